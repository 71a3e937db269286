#include <cstdio>
#include <memory>
#include <string>

#include "sim/app/commands.h"
#include "sim/app/completion.h"
#include "sim/app/exit_codes.h"

namespace dockyard {
namespace {

constexpr const char* kCompletionHelp =
    R"(Print a script by which a shell completes commands, options and files.

Examples:
  dockyard completion bash >out/dockyard.bash
  dockyard completion zsh >out/_dockyard
  dockyard completion fish >out/dockyard.fish

bash: source the file, or put it as `dockyard` into ~/.local/share/bash-completion/completions.
zsh: put _dockyard into a folder of $fpath. fish: put the file into ~/.config/fish/completions.)";

}  // namespace

void AddCompletionCommand(CLI::App& app, Invocation& call) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("completion", kCompletionHelp);
  command->add_option("SHELL", *shell, "whose script")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->callback([&app, shell, &call] {
    std::printf("%s", CompletionScript(app, call.systems, *shell).c_str());
    call.exit_code = kExitDone;
  });
}

}  // namespace dockyard
