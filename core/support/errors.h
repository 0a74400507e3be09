#pragma once

#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace esm {

/// A file that cannot be read or written. The message is one line: file, what is wrong and where, what to do.
class FileError : public std::runtime_error {
public:
    /// @param problem what is wrong, where in the file, and what to do about it; without the file's name
    FileError(const std::filesystem::path& file, const std::string& problem)
        : std::runtime_error(file.string() + ": " + problem) {}
};

/// A request the data cannot satisfy: an impossible size, an unknown name, a scene that names a missing node.
/// Lists every problem found, not just the first.
class InvalidModel : public std::runtime_error {
public:
    explicit InvalidModel(std::vector<std::string> problems);
    explicit InvalidModel(const std::string& problem) : InvalidModel(std::vector<std::string>{problem}) {}

    const std::vector<std::string>& problems() const { return m_problems; }

private:
    std::vector<std::string> m_problems;
};

/// Thrown out of long work when its progress callback asked to stop. Nothing was changed.
class Cancelled : public std::runtime_error {
public:
    Cancelled() : std::runtime_error("cancelled") {}
};

/// Why something failed, in the user's words: what the error says, except where the standard library words it
/// for programmers. A part of a sentence, without a full stop.
std::string reasonOf(const std::exception& error);

} // namespace esm
