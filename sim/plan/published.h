// What a publication says of an experiment, and the campaigns that do it again. Read from a file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "models/read/yaml_tree.h"

namespace dockyard {

/// A name that must be one of the campaign's or of its system's.
struct PublishedName {
  std::string text;
  YamlPlace place;
  std::string path;  // of keys, for messages
};

/// Runs whose label has one of these texts.
struct LabelFilter {
  PublishedName label;
  std::vector<std::string> texts;
};

/// Runs whose column of results.csv has one of these numbers.
struct ColumnFilter {
  PublishedName column;
  std::vector<double> values;
};

struct PublishedCount {
  int count = 0, runs = 0;
};

/// A row of the table of rates.
struct PublishedRow {
  std::string name;
  std::optional<PublishedCount> paper;      // successes; none: not published
  std::vector<LabelFilter> where;           // all must hold
  std::optional<PublishedName> campaign{};  // none: the first
  int runs = 0;  // that it must have here; 0: the paper's, each once a replication
  std::vector<PublishedName> outcomes{};  // that it counts; empty: those of `counted`
  std::string says{};                     // in place of the paper's count
};

/// A way to tell a class of failures from a run: all that is set must hold.
struct FailureCase {
  std::vector<PublishedName> outcomes{};  // one of these; empty: any
  bool wrong_sighting = false;            // the last accepted one is wrong
  std::vector<std::string> methods{};     // of the last accepted sighting; empty: any
  std::vector<ColumnFilter> where{};
};

struct FailureClass {
  std::string name;
  std::optional<PublishedCount> paper;  // failures
  std::string says;                     // about the paper's count, or in place of one
  std::vector<LabelFilter> where;
  std::vector<FailureCase> cases;  // one must hold
  bool judged = false;             // its count is held against the paper's
};

/// A measure over runs, beside the range that was published. NaN: none was.
struct PublishedMeasure {
  std::string name;
  PublishedName campaign, measure;
  std::vector<LabelFilter> where;
  double low = 0.0, high = 0.0;
  bool counted = false;  // over the runs alone that count as the paper's success
  bool judged = false;   // its mean must lie within the range
};

/// Mean errors of the sightings about a distance. NaN: not published.
struct PublishedError {
  double at_m = 0.0, r_m = 0.0, heading_rad = 0.0;
};

struct PublishedFigure {
  enum class Kind { kStarts, kRun };
  std::string file, title;  // the file's name without .svg
  Kind kind = Kind::kStarts;
  std::vector<LabelFilter> where;  // kRun: the first run that counts and these hold
  std::optional<PublishedName> least_measure;
  double least = 0.0;
  std::vector<PublishedName> channels;  // of the history
};

struct PublishedCampaign {
  std::string name, file;
};

struct Published {
  std::string name, file, source;
  std::vector<PublishedCampaign> campaigns;  // the first has the rows
  int replications = 1;                      // of its runs
  std::vector<PublishedName> counted;        // outcomes that count as the paper's success
  std::vector<PublishedName> strict;         // those that are truly one; may be empty
  std::vector<PublishedRow> rows;
  std::size_t total = 0;            // of rows: judged at the confidence itself
  std::vector<std::size_t> judged;  // of rows: each at 1 - (1 - confidence) / their number
  std::vector<FailureClass> failures;
  std::string others;  // what the paper says of all other failures; may be empty
  double wrong_place_m = 0.0, wrong_heading_rad = 0.0;  // a sighting is wrong beyond one of them
  std::vector<std::string> methods;                     // of the sightings in `errors`; empty: any
  double within_m = 0.0;                                // of their distances
  std::vector<PublishedError> errors;
  std::vector<PublishedMeasure> measures;
  std::vector<PublishedFigure> figures;
  std::string choices_file;  // what the publication leaves open and what was chosen; may be empty
};

/// Throws ConfigError with file, line and column. What the campaigns must have is checked by
/// CheckPublished.
Published LoadPublished(const std::string& file);

/// What a campaign of the file has.
struct CampaignNames {
  std::vector<std::string> labels, outcomes, measures, channels;
};
/// By the campaigns of the file, in their order. Throws ConfigError for a name that is not there.
void CheckPublished(const Published& published, const std::vector<CampaignNames>& campaigns);

}  // namespace dockyard
