#!/bin/sh
# Stands in for build/crawford, make and ctest where the commands of the documents are tried: what would take longer than
# some seconds is cut, or looked at and not done.
#
#   PROGRAM  the built crawford        TREE  the source tree        REST  PATH without the stand-ins

# What the program makes of a command before it computes: in a folder where out and DIR are no directories, all that can be
# wrong with it is the folder. (old/verify.json is an earlier run's, which nobody has here.)
look_at() {
  cd refused
  said=$("$PROGRAM" "$@" 2>&1 >/dev/null) || true
  case "$said" in
    'crawford: cannot write out'* | 'crawford: cannot write DIR'* | 'crawford: DIR holds no results'* | \
      'crawford: old/verify.json cannot be read'*) exit 0 ;;
  esac
  echo "$said"
  exit 1
}

case "$(basename "$0") $*" in
  # Targets install, build, verify and draw, for minutes and more: they must be there.
  make\ *) PATH=$REST exec make -n -C "$TREE" "$@" ;;
  # The tests themselves: which they are.
  ctest\ *)
    for word; do
      shift
      [ "$word" = build ] && word=$(dirname "$PROGRAM")
      set -- "$@" "$word"
    done
    PATH=$REST exec ctest -N "$@"
    ;;
  # A minute or two, of which the documents go on from checkpoints: a coarse grid, all steps.
  crawford\ burn\ *out/sandwich*) exec "$PROGRAM" "$@" --quiet --set domain.nx=16 --set domain.ny=24 ;;
  # The same and longer, each by itself: longer steps too.
  crawford\ burn\ *) exec "$PROGRAM" "$@" --quiet --set domain.nx=16 --set domain.ny=24 --set 'time.step="100 us"' ;;
  # Eleven seconds as in the paper.
  'crawford run fig03 fig04') exec "$PROGRAM" "$@" --quiet --fidelity draft ;;
  # Minutes to an hour: the studies, the movie, the matrix of model forms, the ledger anew.
  crawford\ verify* | crawford\ run\ * | crawford\ ledger\ --settle*) look_at "$@" ;;
  # Pages of a folder that nobody has here.
  crawford\ report\ --out\ DIR) look_at "$@" ;;
  *) exec "$PROGRAM" "$@" ;;
esac
