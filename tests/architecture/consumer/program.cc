// The program, in another project.
#include "sim/app/program.h"
#include "sim/app/systems.h"

int main(int argc, char** argv) { return dockyard::RunProgram(argc, argv, dockyard::Systems()); }
