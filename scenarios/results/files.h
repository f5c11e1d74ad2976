// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace horopter::scenarios {

/// Creates a folder and what is above it. @throws ResultsError
void CreateFolder(const std::filesystem::path& folder);

/// Replaces the file whole: a reader, or a crash, sees the old content or the new, never a part.
/// Writes a temporary in the same folder, flushes it to the disk and renames it.
/// @throws ResultsError; the old content then stands and the temporary is gone
void WriteFileAtomically(const std::filesystem::path& file, std::string_view content);

/// @throws ResultsError
std::string ReadFile(const std::filesystem::path& file);

/// Writes all bytes to a descriptor, over interruptions.
/// @param file for the message @throws ResultsError
void WriteFully(int descriptor, std::string_view content, const std::filesystem::path& file);

/// "cannot write results to PLACE: REASON; REMEDY" for an errno value.
std::string WriteFailure(const std::filesystem::path& place, int error);

}  // namespace horopter::scenarios
