; A block that goes on over several lines.
(block) @fold
