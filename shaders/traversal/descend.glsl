// Where the candidates of a child are: its parent's list of pairs, and the child's own words of the masks.

/// A range of children and their parents' lists, for the kernel that tests and the one that emits pairs.
struct Slice {
  uint first_child;  // of the level below
  uint child_count;
  uint first_parent;
  uint parent_count;
  uint first_base;    // element of `bases` that belongs to first_parent
  uint pairs_before;  // value of that element
  uint arity;         // most children of a parent
};

struct List {
  uint begin;  // first pair of the parent
  uint end;
  uint first_mask;  // of this child: a word 32 pairs
};

/// Words have their places without another scan: those of a parent whose list begins at b begin at (b / 32 + the
/// parent's place) × arity.
List list_of(Slice slice, uint begin, uint end, uint parent_place, uint child_place) {
  uint words = (end - begin + 31u) / 32u;
  return List(begin, end, (begin / 32u + parent_place) * slice.arity + child_place * words);
}
