// What a wrong word was meant to be: of known names, and of the files that are there.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace dockyard {

bool DiffersInCaseAlone(std::string_view a, std::string_view b);

/// The known name nearest to the given one: one that differs in its case alone, else by edit
/// distance (Levenshtein); empty if none is near.
std::string NearestName(std::string_view name, const std::vector<std::string>& known);

/// ", did you mean 'seed'?" for the known name nearest to the given one, else for the only one that
/// begins with it; empty if there is none.
std::string DidYouMean(std::string_view name, const std::vector<std::string>& known);

/// The same, or else all that are known: "; known are 'a', 'b'".
std::string DidYouMeanOrKnown(std::string_view name, const std::vector<std::string>& known);

/// Notes a name; ConfigError where it is taken already. Results and controllers find things by it.
void TakeName(const std::string& name, const std::string& place, std::vector<std::string>& taken);

/// The file or folder that a path without one was likely meant to be: a like name in the folder
/// that it names, under a like folder, or in scenarios/. Empty: there is none.
std::string NearFile(const std::filesystem::path& path);
/// The same as the end of a message: ", did you mean 'scenarios/near.yaml'?"
std::string DidYouMeanFile(const std::filesystem::path& path);

}  // namespace dockyard
