#include "canonical/census.hpp"
#include "fuzz/fuzzer.hpp"

// What is complete in a journal, written out, is complete and the same; a census comes of it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tripus;
  const auto write = [](const canonical::JournalText& journal) {
    std::string text;
    for (const canonical::CensusLine& line : journal.lines)
      text += canonical::to_journal(line) + '\n';
    return text;
  };
  try {
    const std::string_view text = fuzz::as_text(data, size);
    const canonical::JournalText journal = canonical::parse_journal(text);
    fuzz::require(journal.complete <= text.size());
    fuzz::require(journal.complete == 0 || text[journal.complete - 1] == '\n');
    const std::string written = write(journal);
    const canonical::JournalText again = canonical::parse_journal(written);
    fuzz::require(again.complete == written.size() && again.lines.size() == journal.lines.size());
    fuzz::require(write(again) == written);
    (void)canonical::make_census(journal.lines);
  } catch (const InvalidInput&) {
  }
  return 0;
}
