package enlightenment.emitter;

/** A point on a light, sampled uniformly over its area, with its unit normal. A mutable work object, one per thread. */
public final class SurfacePoint {
    public double x;
    public double y;
    public double z;

    /** The unit normal: outward, or on the front of a flat light. */
    public double nx;

    public double ny;
    public double nz;

    /** Scratch for a point in the unit disk. */
    final double[] disk = new double[3];

    /** Makes a point to be set before use. */
    public SurfacePoint() {}

    void set(double px, double py, double pz) {
        x = px;
        y = py;
        z = pz;
    }

    void setNormal(double px, double py, double pz) {
        nx = px;
        ny = py;
        nz = pz;
    }
}
