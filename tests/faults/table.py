"""The table at the end."""


class Row:
    def __init__(self, fault):
        self.fault, self.tries, self.losses, self.seen = fault, 0, [], ""

    def tried(self, is_kept, loss=""):
        self.tries += 1
        if not is_kept:
            self.losses.append(loss)

    def lost(self, loss):
        self.losses.append(loss)

    def saw(self, seen):
        self.seen = seen


def text(rows):
    width = max(len(row.fault) for row in rows)
    lines = [f"{'fault':<{width}}  tries  lost  what was seen"]
    for row in rows:
        lines.append(f"{row.fault:<{width}}  {row.tries:>5}  {len(row.losses):>4}  {row.seen}")
    lines.append(f"{'all':<{width}}  {sum(r.tries for r in rows):>5}  {sum(len(r.losses) for r in rows):>4}")
    return "\n".join(lines)
