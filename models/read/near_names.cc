#include "models/read/near_names.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <system_error>

#include "models/read/config_error.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

std::size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

std::string Question(const std::string& name) {
  return name.empty() ? "" : ", did you mean '" + name + "'?";
}

std::string OnlyLonger(std::string_view name, const std::vector<std::string>& known) {
  constexpr std::size_t kFewest = 3;  // fewer letters begin too many names
  std::string longer;
  for (const std::string& each : known) {
    if (name.size() < kFewest || !each.starts_with(name)) continue;
    if (!longer.empty()) return "";
    longer = each;
  }
  return longer;
}

/// In the order of their names. A very large folder gives the first that come.
std::vector<fs::path> NamesIn(const fs::path& folder) {
  constexpr std::size_t kMost = 5000;
  std::error_code error;
  std::vector<fs::path> names;
  fs::directory_iterator at(folder, error);
  for (; !error && at != fs::directory_iterator() && names.size() < kMost; at.increment(error)) {
    names.push_back(at->path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// A name of the same ending that is near, else one that differs in its ending alone.
fs::path NearName(const fs::path& name, const fs::path& folder) {
  const std::vector<fs::path> names = NamesIn(folder);
  std::vector<std::string> stems;
  for (const fs::path& each : names) {
    if (each.extension() == name.extension()) stems.push_back(each.stem().string());
  }
  const std::string stem = NearestName(name.stem().string(), stems);
  if (!stem.empty()) return stem + name.extension().string();
  for (const fs::path& each : names) {
    if (each.stem() == name.stem()) return each;
  }
  return {};
}

/// The path with every part that is not there replaced by a near one; empty if one has none.
fs::path WithNearParts(const fs::path& path) {
  fs::path known;
  std::error_code ignored;
  for (const fs::path& part : path) {
    fs::path next = known / part;
    if (!fs::exists(next, ignored)) {
      const fs::path near = NearName(part, known.empty() ? fs::path(".") : known);
      if (near.empty()) return {};
      next = known / near;
    }
    known = next;
  }
  return known;
}

}  // namespace

bool DiffersInCaseAlone(std::string_view a, std::string_view b) {
  const auto low = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return a != b && std::equal(a.begin(), a.end(), b.begin(), b.end(),
                              [&](char x, char y) { return low(x) == low(y); });
}

std::string NearestName(std::string_view name, const std::vector<std::string>& known) {
  if (name.size() > 64) return {};
  std::string nearest;
  std::size_t best = 2 + name.size() / 3;  // a name farther off is no likely typing error
  for (const std::string& candidate : known) {
    if (DiffersInCaseAlone(name, candidate)) return candidate;
    const std::size_t distance = EditDistance(name, candidate);
    if (distance < best) {
      best = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string DidYouMean(std::string_view name, const std::vector<std::string>& known) {
  const std::string longer = OnlyLonger(name, known);
  return Question(longer.empty() ? NearestName(name, known) : longer);
}

std::string DidYouMeanOrKnown(std::string_view name, const std::vector<std::string>& known) {
  const std::string near = DidYouMean(name, known);
  if (!near.empty() || known.empty()) return near;
  std::string all;
  for (const std::string& each : known) all += (all.empty() ? "'" : ", '") + each + "'";
  return "; known are " + all;
}

void TakeName(const std::string& name, const std::string& place, std::vector<std::string>& taken) {
  if (std::find(taken.begin(), taken.end(), name) != taken.end())
    throw ConfigError(place + ": expected a name of its own, found a second '" + name + "'");
  taken.push_back(name);
}

std::string NearFile(const fs::path& path) {
  std::error_code ignored;
  if (path.empty() || fs::exists(path, ignored)) return "";
  const fs::path near = WithNearParts(path);
  if (!near.empty()) return near.string();
  const fs::path usual = "scenarios";
  if (!path.has_filename() || !fs::is_directory(usual, ignored)) return "";
  const fs::path there = usual / path.filename();
  return fs::exists(there, ignored) ? there.string() : WithNearParts(there).string();
}

std::string DidYouMeanFile(const fs::path& path) { return Question(NearFile(path)); }

}  // namespace dockyard
