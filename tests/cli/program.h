// Runs the built program as a shell would, without a display.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/image/image.h"

namespace dermis::test {

struct ProgramResult {
  int exitCode = -1;  ///< -1: did not end by itself
  std::string output;
  std::vector<std::string> errors;    ///< lines of stderr that are no warnings
  std::vector<std::string> warnings;  ///< lines "warning: …"
  [[nodiscard]] std::string allErrors() const {
    std::string text;
    for (const std::string& line : errors) text += line + "\n";
    return text;
  }
};

/// DISPLAY and WAYLAND_DISPLAY are taken away; `environment` adds to or replaces what is left. Ends the program after
/// two minutes.
ProgramResult runDermis(const std::vector<std::string>& arguments,
                        const std::map<std::string, std::string>& environment = {});
/// The same of a program that lies elsewhere.
ProgramResult runProgram(const std::string& program, const std::vector<std::string>& arguments,
                         const std::map<std::string, std::string>& environment = {});

/// A picture that the program wrote; a failure of the test, and empty, where it can't be read.
Image readPicture(const std::filesystem::path& file);

}  // namespace dermis::test
