#!/bin/sh
# What has become of a job, in the three words that Snakemake 7 asks for. squeue knows a job for some minutes after its end
# (MinJobAge); sacct knows it for good, where accounting is set up.
state=$(squeue --noheader --states=all --format=%T --jobs="$1" 2>/dev/null | head -n 1)
[ -n "$state" ] || state=$(sacct --noheader --parsable2 --allocations --format=State --jobs="$1" 2>/dev/null | head -n 1)
case "$state" in
  COMPLETED) echo success ;;
  PENDING | CONFIGURING | COMPLETING | RUNNING | SUSPENDED | REQUEUED | RESIZING) echo running ;;
  # Nobody knows it: where the controller is only away, wait; else burn it again, which ends at once if it was done.
  '') if scontrol ping 2>/dev/null | grep -q 'is UP'; then echo failed; else echo running; fi ;;
  *) echo failed ;;
esac
