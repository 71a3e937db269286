#include "sim/app/failure.h"

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>

#include "models/read/config_error.h"
#include "models/read/text_file.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/parse_fault.h"
#include "sim/app/terminal.h"
#include "sim/base/folder.h"
#include "sim/base/shell_word.h"
#include "sim/bridge/sandbox.h"
#include "sim/campaign/campaign.h"
#include "sim/log/run_log.h"
#include "sim/scenario/other_file_kind.h"

namespace dockyard {
namespace {

template <class... Kinds>
bool IsOneOf(const std::exception& error) {
  return ((dynamic_cast<const Kinds*>(&error) != nullptr) || ...);
}

int ExitCodeOf(const std::exception& error) {
  if (IsOneOf<UsageError, FolderTaken, SandboxError>(error)) return kExitUsage;
  if (IsOneOf<ConfigError, ResultsError, DataError, UnsafeContent>(error)) return kExitBadInput;
  if (IsOneOf<IoError, std::filesystem::filesystem_error>(error)) return kExitIo;
  return kExitOurBug;
}

/// The whole number of ":12" at a place, and the place after it.
std::optional<int> NumberAfterColon(const std::string& text, std::size_t& at) {
  int number = 0;
  if (at >= text.size() || text[at] != ':') return std::nullopt;
  const char* begin = text.data() + at + 1;
  const auto read = std::from_chars(begin, text.data() + text.size(), number);
  if (read.ec != std::errc()) return std::nullopt;
  at = static_cast<std::size_t>(read.ptr - text.data());
  return number;
}

bool NamesFile(const std::string& text) {
  std::error_code ignored;
  return text.find_first_of("/.") != text.npos && text.find(' ') == text.npos &&
         text.rfind("--", 0) != 0;
}

int Fail(const std::string& text, int exit_code, bool as_json,
         const std::vector<std::string>& warnings) {
  PrintError(text);
  if (as_json) {
    // As on stderr: a byte that is no UTF-8 cannot be in JSON.
    const Json answer{{"error", ErrorJson(WithControlsShown(text), exit_code)},
                      {"warnings", warnings}};
    std::printf("%s\n", answer.dump().c_str());
  }
  return exit_code;
}

}  // namespace

Json ErrorJson(const std::string& text, int exit_code) {
  Json json{{"text", text},
            {"file", nullptr},
            {"line", nullptr},
            {"column", nullptr},
            {"exit_code", exit_code}};
  for (std::size_t colon = text.find(':'); colon != text.npos; colon = text.find(':', colon + 1)) {
    std::size_t at = colon;
    const auto line = NumberAfterColon(text, at), column = NumberAfterColon(text, at);
    if (!line || !column || text.compare(at, 2, ": ") != 0) continue;
    json["file"] = text.substr(0, colon);
    json["line"] = *line;
    json["column"] = *column;
    return json;
  }
  const std::string head = text.substr(0, text.find(": "));
  if (head.size() < text.size() && NamesFile(head)) json["file"] = head;
  return json;
}

int WithFailuresTold(const CLI::App& app, const Invocation& call, bool as_json,
                     const std::function<int()>& work) {
  const auto fail = [&](const std::string& text, int exit_code) {
    return Fail(text, exit_code, as_json, call.warnings);
  };
  try {
    return work();
  } catch (const CLI::Success& asked) {  // help, version
    return app.exit(asked, std::cout, std::cerr);
  } catch (const CLI::ParseError& error) {
    return fail(ParseFault(app, error, call.program), kExitUsage);
  } catch (const OtherFileKind& other) {
    return fail(std::string(other.what()) + "; simulate it with: " +
                    CommandText(call.program, {other.command(), other.file()}),
                ExitCodeOf(other));
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory; give the program more (ulimit -v, ulimit -d)",
                kExitIo);
  } catch (const std::exception& error) {
    return fail(error.what(), ExitCodeOf(error));
  }
}

}  // namespace dockyard
