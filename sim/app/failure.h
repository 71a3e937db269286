// What ends a command early: the message, the exit code, and the same as JSON where it was asked.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "sim/app/invocation.h"
#include "sim/base/json.h"

namespace dockyard {

/// The object under "error": the text, with file, line and column where it opens with them, null
/// where it does not, and the exit code.
Json ErrorJson(const std::string& text, int exit_code);

/// Calls `work` and returns its exit code. An exception is printed on stderr, with `as_json` as
/// an object on stdout too, and becomes the exit code of docs/reference/exit_codes.md.
/// @param app   for the sentence on arguments that cannot be read
/// @param call  its warnings are in the object
int WithFailuresTold(const CLI::App& app, const Invocation& call, bool as_json,
                     const std::function<int()>& work);

}  // namespace dockyard
