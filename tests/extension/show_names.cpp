// Prints what the viewer can show, a line each.

#include <cstdio>

#include "viewer/show.h"

int main() {
  for (const crsh::viewer::ShowRow& row : crsh::viewer::show_table()) std::puts(std::string(row.name).c_str());
}
