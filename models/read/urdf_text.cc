#include "models/read/urdf_text.h"

#include <console_bridge/console.h>

#include "models/read/config_error.h"

namespace dockyard {
namespace {

/// Catches the messages of liburdfdom, as long as it lives.
class Complaints : public console_bridge::OutputHandler {
 public:
  Complaints() { console_bridge::useOutputHandler(this); }
  ~Complaints() override { console_bridge::restorePreviousOutputHandler(); }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) text_ += "; " + text;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace

std::string TextOfXml(const TiXmlElement& element) {
  TiXmlPrinter printer;
  printer.SetStreamPrinting();
  element.Accept(&printer);
  return printer.Str();
}

urdf::ModelInterfaceSharedPtr ParseUrdfText(const std::string& text, const std::string& place) {
  const Complaints complaints;
  try {
    auto model = urdf::parseURDF(text);
    // After an error it continues without the faulty part.
    if (model && complaints.text().empty()) return model;
  } catch (const std::exception& error) {
    throw ConfigError(place + ": " + std::string("not a usable URDF: ") + error.what());
  }
  throw ConfigError(place + ": not a usable URDF: liburdfdom refuses it" + complaints.text());
}

}  // namespace dockyard
