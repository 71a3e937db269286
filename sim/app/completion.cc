#include "sim/app/completion.h"

#include <utility>
#include <vector>

#include "sim/app/help.h"
#include "sim/base/shell_word.h"

namespace dockyard {
namespace {

struct Offer {
  std::string word, meaning;
  std::vector<std::string> values = {};  // of an option: the words that it takes
  bool takes_value = false;
};

/// What may follow a command.
struct Context {
  std::string path;  // "camera project"; empty for the program itself
  std::vector<Offer> commands, options, arguments;
};

std::string FirstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

/// The words of "TEXT:{a,b}".
std::vector<std::string> ValuesOf(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t open = type.find('{');
  std::vector<std::string> values;
  if (open == type.npos || type.back() != '}') return values;
  std::string word;
  for (const char c : type.substr(open + 1)) {
    if (c != ',' && c != '}') {
      word += c;
      continue;
    }
    values.push_back(std::exchange(word, ""));
  }
  return values;
}

void AddContexts(const CLI::App& command, const std::string& path, std::vector<Context>& contexts) {
  Context context{path, {}, {}, {}};
  std::vector<const CLI::App*> inner;
  for (const CLI::App* each : command.get_subcommands({})) {
    if (each->get_group().empty()) continue;
    context.commands.push_back({each->get_name(), Summary(*each)});
    inner.push_back(each);
  }
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) {
      for (const std::string& value : ValuesOf(*option)) context.arguments.push_back({value, ""});
    }
    for (const std::string& name : option->get_lnames()) {
      context.options.push_back({"--" + name, FirstLine(option->get_description()),
                                 ValuesOf(*option), option->get_type_size() != 0});
    }
  }
  contexts.push_back(std::move(context));
  for (const CLI::App* each : inner) {
    AddContexts(*each, path.empty() ? each->get_name() : path + " " + each->get_name(), contexts);
  }
}

/// The program's own commands know their options; a system's reads its words itself.
void AddOptionsOf(const std::vector<System>& systems, Context& context) {
  for (const System& system : systems) {
    std::vector<SystemCommand> all = system.commands;
    if (system.detect.run) all.push_back(system.detect);
    for (const SystemCommand& own : all) {
      if (own.name != context.path) continue;
      for (const CommandOption& option : own.options) {
        context.options.push_back({option.name, FirstLine(option.meaning), {}, option.takes_value});
      }
    }
  }
}

std::vector<Context> ContextsOf(const CLI::App& app, const std::vector<System>& systems) {
  std::vector<Context> contexts;
  AddContexts(app, "", contexts);
  for (Context& context : contexts) {
    if (context.path == "help") context.arguments = contexts.front().commands;
    AddOptionsOf(systems, context);
  }
  return contexts;
}

std::string Words(const std::vector<Offer>& offers) {
  std::string text;
  for (const Offer& offer : offers) text += (text.empty() ? "" : " ") + offer.word;
  return text;
}

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// In bash and zsh: `command` becomes the commands among the words before the one that is
/// completed.
std::string FindCommand(const std::vector<Context>& contexts, const std::string& words_before) {
  std::string known;
  for (const Context& context : contexts) {
    const std::string head = context.path.empty() ? "" : context.path;
    for (const Offer& inner : context.commands) {
      known += (known.empty() ? "" : "|") + ("\"" + head + " " + inner.word + "\"");
    }
  }
  return "  local command= word\n  for word in " + words_before +
         "; do\n    case \"$command $word\" in\n      " + known +
         ")\n        command=\"${command:+$command }$word\" ;;\n    esac\n  done\n";
}

/// "path previous": the cases in which an option's value is one of its words.
std::string ValueCases(const std::vector<Context>& contexts, const std::string& before,
                       const std::string& after) {
  std::string text;
  for (const Context& context : contexts) {
    for (const Offer& option : context.options) {
      if (option.values.empty()) continue;
      text += "    \"" + context.path + " " + option.word + "\") " + before +
              Joined(option.values) + after + " ;;\n";
    }
  }
  return text;
}

std::string BashScript(const std::vector<Context>& contexts) {
  std::string text =
      "# bash completion for dockyard, printed by: dockyard completion bash\n_dockyard() {\n"
      "  local current=\"${COMP_WORDS[COMP_CWORD]}\" previous=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
      "  local words= options=\n  COMPREPLY=()\n";
  text += FindCommand(contexts, "\"${COMP_WORDS[@]:1:COMP_CWORD-1}\"");
  text += "  case \"$command $previous\" in\n" +
          ValueCases(contexts, "COMPREPLY=($(compgen -W \"", "\" -- \"$current\")); return") +
          "  esac\n  case \"$command\" in\n";
  for (const Context& context : contexts) {
    text += "    \"" + context.path + "\") words=\"" + Words(context.commands) +
            (context.commands.empty() || context.arguments.empty() ? "" : " ") +
            Words(context.arguments) + "\" options=\"" + Words(context.options) + "\" ;;\n";
  }
  return text +
         "  esac\n  [[ $current == -* ]] && words=\"$options\"\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n}\n"
         "# Where nothing is offered, files are.\n"
         "complete -o default -F _dockyard dockyard\n";
}

/// "name:meaning" as a word of the shell; a colon in the meaning stays.
std::string Described(const Offer& offer) {
  return ShellWord(offer.word + (offer.meaning.empty() ? "" : ":" + offer.meaning));
}

std::string ZshScript(const std::vector<Context>& contexts) {
  std::string text =
      "#compdef dockyard\n# zsh completion for dockyard, printed by: dockyard completion zsh\n"
      "_dockyard() {\n  local previous=\"${words[CURRENT-1]}\"\n  local -a offered options\n";
  text += FindCommand(contexts, "\"${(@)words[2,CURRENT-1]}\"");
  text += "  case \"$command $previous\" in\n" +
          ValueCases(contexts, "offered=(", "); _describe value offered; return") +
          "  esac\n  case \"$command\" in\n";
  for (const Context& context : contexts) {
    text += "    \"" + context.path + "\")\n      offered=(";
    for (const auto* offers : {&context.commands, &context.arguments}) {
      for (const Offer& offer : *offers) text += " " + Described(offer);
    }
    text += ")\n      options=(";
    for (const Offer& option : context.options) text += " " + Described(option);
    text += ") ;;\n";
  }
  return text +
         "  esac\n  if [[ $PREFIX == -* ]]; then\n    _describe option options\n"
         "  elif (( $#offered )); then\n    _describe command offered\n  else\n    _files\n  "
         "fi\n}\n"
         "if [[ $funcstack[1] == _dockyard ]]; then\n  _dockyard \"$@\"\nelse\n"
         "  compdef _dockyard dockyard\nfi\n";
}

/// True while the commands of the path are there and none that would follow them.
std::string FishCondition(const Context& context) {
  std::string condition;
  std::string path = context.path;
  while (!path.empty()) {
    const std::string word = path.substr(0, path.find(' '));
    condition += "__fish_seen_subcommand_from " + word + "; and ";
    path.erase(0, std::min(path.size(), word.size() + 1));
  }
  if (context.path.empty()) return "__fish_use_subcommand";
  if (context.commands.empty()) return condition + "true";
  return condition + "not __fish_seen_subcommand_from " + Words(context.commands);
}

std::string FishScript(const std::vector<Context>& contexts) {
  std::string text = "# fish completion for dockyard, printed by: dockyard completion fish\n";
  for (const Context& context : contexts) {
    const std::string head = "complete -c dockyard -n " + ShellWord(FishCondition(context));
    for (const auto* offers : {&context.commands, &context.arguments}) {
      for (const Offer& offer : *offers) {
        text += head + " -f -a " + ShellWord(offer.word) +
                (offer.meaning.empty() ? "" : " -d " + ShellWord(offer.meaning)) + "\n";
      }
    }
    for (const Offer& option : context.options) {
      text += head + " -l " + option.word.substr(2) + (option.takes_value ? " -r" : "") +
              (option.values.empty() ? "" : " -x -a " + ShellWord(Joined(option.values))) + " -d " +
              ShellWord(option.meaning) + "\n";
    }
  }
  return text;
}

}  // namespace

std::string CompletionScript(const CLI::App& app, const std::vector<System>& systems,
                             const std::string& shell) {
  const std::vector<Context> contexts = ContextsOf(app, systems);
  if (shell == "bash") return BashScript(contexts);
  return shell == "zsh" ? ZshScript(contexts) : FishScript(contexts);
}

}  // namespace dockyard
