// The self-test's kernels in float, for lint and editors.
