// Template: cameras that see something everywhere in their picture store nothing. The includer has defined CameraView.

/// Whether there is a ray through picture point (x, y).
FUNCTION void store_seen(global uchar *seen, uint i, CameraView view, float x, float y) {}
