// Commands that a system brings with it.

#include "sim/app/commands.h"

namespace dockyard {

void AddSystemCommands(CLI::App& app, Invocation& call) {
  for (const System& system : call.systems) {
    for (const SystemCommand& own : system.commands) {
      CLI::App* command = app.add_subcommand(own.name, own.help);
      command->group("Of the system " + system.name);
      command->prefix_command();  // what follows is the system's to read, --help too
      command->set_help_flag();
      command->callback([command, run = own.run, &call] {
        call.exit_code = run(call.program, command->remaining());
      });
    }
  }
}

}  // namespace dockyard
