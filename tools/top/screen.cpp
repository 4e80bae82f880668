#include "tools/top/screen.hpp"

#include <algorithm>
#include <string>

#include <curses.h>

namespace perceptor {
namespace {

constexpr short kAlarm = 1;

chtype attributes(Row::Look look) {
  if (look == Row::Look::title) return A_BOLD;
  return look == Row::Look::alarm ? COLOR_PAIR(kAlarm) : A_NORMAL;
}

}  // namespace

Screen::Screen() {
  initscr();
  cbreak();
  noecho();
  curs_set(0);
  nodelay(stdscr, TRUE);
  if (has_colors()) {
    start_color();
    use_default_colors();
    init_pair(kAlarm, COLOR_RED, -1);
  }
}

Screen::~Screen() { endwin(); }

void Screen::show(const std::vector<Row>& rows) {
  erase();
  const int room = LINES - 1;
  const int count = static_cast<int>(rows.size());
  for (int i = 0; i < std::min(count, room); ++i) {
    const Row& row = rows[static_cast<std::size_t>(i)];
    attron(attributes(row.look));
    mvaddnstr(i, 0, row.text.c_str(), COLS);
    attroff(attributes(row.look));
  }
  std::string help = "q ends; red: something was lost, turned down, or has stopped";
  if (count > room)
    help = std::to_string(count - room) + " more rows: make the window higher. " + help;
  mvaddnstr(room, 0, help.c_str(), COLS);
  refresh();
}

bool Screen::wants_to_end() { return getch() == 'q'; }

}  // namespace perceptor
