#pragma once

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace gridstep {

/// The columns that a line may take where a person reads the stream on a terminal, asked anew each time because windows
/// are resized; none for files and pipes. One less than the window has: a line that fills the last column would wrap on
/// some terminals.
std::optional<std::size_t> line_width(std::FILE* stream);

/// Whether a line of the stream can be drawn over: on a terminal, but not on a dumb one (an editor's window, a log), nor
/// where NO_COLOR asks for plain text (no-color.org).
bool can_redraw(std::FILE* stream);

/// Lines that are wider are broken between words; what follows is indented by two more than the line. A word that is too
/// long, such as a path, stays whole.
std::string fold(std::string_view text, std::size_t width);

}  // namespace gridstep
