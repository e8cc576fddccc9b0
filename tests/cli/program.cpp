#include "cli/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <sstream>
#include <utility>

#include "core/io/importer.h"

namespace dermis::test {
namespace {

constexpr std::chrono::minutes kLongest{2};

std::vector<std::string> environmentText(const std::map<std::string, std::string>& changes) {
  std::map<std::string, std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const std::size_t equals = text.find('=');
    if (equals != std::string::npos) all[text.substr(0, equals)] = text.substr(equals + 1);
  }
  all.erase("DISPLAY");
  all.erase("WAYLAND_DISPLAY");
  for (const auto& [key, value] : changes) all[key] = value;
  std::vector<std::string> result;
  result.reserve(all.size());
  for (const auto& [key, value] : all) result.emplace_back(key).append(1, '=').append(value);
  return result;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  result.reserve(texts.size() + 1);
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// Reads both pipes to their ends, or until the time is over.
bool drain(std::array<int, 2> pipes, std::array<std::string, 2>& texts) {
  const auto deadline = std::chrono::steady_clock::now() + kLongest;
  int open = 2;
  while (open > 0) {
    std::array<pollfd, 2> waits = {{{pipes[0], POLLIN, 0}, {pipes[1], POLLIN, 0}}};
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now()).count();
    if (left <= 0 || poll(waits.data(), 2, static_cast<int>(left)) <= 0) return false;
    for (std::size_t i = 0; i < 2; ++i) {
      if (pipes.at(i) < 0 || waits.at(i).revents == 0) continue;
      std::array<char, 4096> block{};
      const ssize_t count = read(pipes.at(i), block.data(), block.size());
      if (count > 0) {
        texts.at(i).append(block.data(), static_cast<std::size_t>(count));
      } else {
        close(pipes.at(i));
        pipes.at(i) = -1;
        --open;
      }
    }
  }
  return true;
}

}  // namespace

ProgramResult runDermis(const std::vector<std::string>& arguments,
                        const std::map<std::string, std::string>& environment) {
  return runProgram(DERMIS_BINARY, arguments, environment);
}

ProgramResult runProgram(const std::string& program, const std::vector<std::string>& arguments,
                         const std::map<std::string, std::string>& environment) {
  std::array<int, 2> out{};
  std::array<int, 2> err{};
  ProgramResult result;
  if (pipe2(out.data(), O_CLOEXEC) != 0 || pipe2(err.data(), O_CLOEXEC) != 0) return result;
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = environmentText(environment);
  const std::vector<char*> argv = pointers(words);
  const std::vector<char*> envp = pointers(variables);
  const pid_t child = fork();
  if (child == 0) {
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, 0);
    dup2(out[1], 1);
    dup2(err[1], 2);
    execve(program.c_str(), argv.data(), envp.data());
    _exit(127);
  }
  close(out[1]);
  close(err[1]);
  std::array<std::string, 2> texts;
  if (!drain({out[0], err[0]}, texts)) kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status)) result.exitCode = WEXITSTATUS(status);
  result.output = texts[0];
  std::istringstream lines(texts[1]);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) (line.starts_with("warning: ") ? result.warnings : result.errors).push_back(line);
  return result;
}

Image readPicture(const std::filesystem::path& file) {
  const auto module = importer();
  Warnings warnings;
  auto image = module ? (*module)->loadImage(file, {}, warnings) : Result<Image>(runtimeError(module.error().message));
  EXPECT_TRUE(image) << (image ? "" : image.error().message);
  return image ? std::move(*image) : Image{};
}

}  // namespace dermis::test
