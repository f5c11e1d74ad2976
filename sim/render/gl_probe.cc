// SPDX-License-Identifier: Apache-2.0
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <exception>

#include "sim/render/gl_context.h"

namespace horopter::sim {
namespace {

constexpr int kProbeSize_px = 16;
constexpr char kWorks = '+';
constexpr char kFails = '-';

/// First character says which, the rest is the driver's name or the problem.
std::string TryHere(const std::string& backend) {
  try {
    const auto context = CreateGlContext(backend, kProbeSize_px, kProbeSize_px);
    context->MakeCurrent();
    return kWorks + context->gl_renderer();
  } catch (const std::exception& error) {
    return kFails + std::string(error.what());
  }
}

GlProbe ProbeOf(const std::string& answer) {
  return answer[0] == kWorks ? GlProbe{answer.substr(1), ""} : GlProbe{"", answer.substr(1)};
}

/// Never returns: no destructor or exit handler of the parent's may run here.
[[noreturn]] void AnswerAndExit(int pipe_end, const std::string& backend) {
  const std::string answer = TryHere(backend);
  std::size_t sent = 0;
  while (sent < answer.size()) {
    const ssize_t n = write(pipe_end, answer.data() + sent, answer.size() - sent);
    if (n <= 0) break;
    sent += static_cast<std::size_t>(n);
  }
  _exit(0);
}

std::string ReadAll(int pipe_end) {
  std::string text;
  std::array<char, 512> buffer{};
  for (;;) {
    const ssize_t n = read(pipe_end, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(n));
  }
}

}  // namespace

GlProbe ProbeGlBackend(std::string_view backend) {
  // A driver's threads do not survive a fork.
  if (!GlBackendInUse().empty()) return ProbeOf(TryHere(std::string(backend)));
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw RenderError(std::strerror(errno));
  const pid_t child = fork();
  if (child < 0) {
    close(ends[0]);
    close(ends[1]);
    throw RenderError(std::strerror(errno));
  }
  if (child == 0) {
    close(ends[0]);
    AnswerAndExit(ends[1], std::string(backend));
  }
  close(ends[1]);
  const std::string answer = ReadAll(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (answer.empty()) return {"", "the driver ended the process that tried it"};
  return ProbeOf(answer);
}

}  // namespace horopter::sim
