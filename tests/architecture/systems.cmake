# The systems, each with its rooms controller/<system>, models/<system>, sim/<system> and tests/<system>, and with
# commands of its own in sim/app/<system>. The build and the firewall read this list.
set(systems axel raposa rocky7 custom)
