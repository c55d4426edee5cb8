package enlightenment.emitter;

import enlightenment.frame.BallCone;

/**
 * An {@link AreaLight} as seen from a receiver, with a sampled point of it: {@link #dx}, {@link #dy}, {@link #dz} is the unit direction to
 * it, {@link #length} its distance. {@link AreaLight#aim} comes first. A mutable work object, one per thread.
 */
public final class LightSample extends EmitterView {
    /** The density of the sample, per solid angle; 0 if there is no sample: the other fields are then undefined. */
    public double pdf;

    /**
     * The cosine at the light between its normal (outward, or on its front) and the direction back to the receiver: negative where the back
     * of a light is seen.
     */
    public double cosine;

    final SphericalRectangle rectangle = new SphericalRectangle();
    final SphericalTriangle triangle = new SphericalTriangle();
    final SphericalTriangle secondTriangle = new SphericalTriangle();
    final HorizonPolygon polygon = new HorizonPolygon();
    final SurfacePoint point = new SurfacePoint();

    /** The technique by which a light with several is sampled from this receiver. */
    SamplingChoice choice = SamplingChoice.UNDECIDED;

    /** The signed distance of the receiver from a flat light's plane, positive in front of it. */
    double height;

    /** Makes a sample with a cone of its own. */
    public LightSample() {
        this(new BallCone());
    }

    /**
     * @param cone receives the cone around the light's bounding ball when the sample is aimed
     */
    public LightSample(BallCone cone) {
        super(cone);
    }

    void aim(double ballX, double ballY, double ballZ, double ballRadius, double x, double y, double z) {
        cone.set(ballX, ballY, ballZ, ballRadius, x, y, z);
        aim();
        choice = SamplingChoice.UNDECIDED;
    }

    void absent() {
        pdf = 0;
    }

    /** Sets direction and distance to the point at the offset (x, y, z) from the receiver. */
    void toOffset(double x, double y, double z) {
        double len = Math.sqrt(x * x + y * y + z * z);
        double inverse = len > 0 ? 1 / len : 0;
        set(x * inverse, y * inverse, z * inverse, len);
    }

    /** Sets the sample to {@link #point}, sampled uniformly over an area. */
    void toPoint(double area, LightSides sides) {
        toOffset(point.x - cone.x, point.y - cone.y, point.z - cone.z);
        cosine = -(dx * point.nx + dy * point.ny + dz * point.nz);
        pdf = pdfOfArea(area, sides, length, cosine);
    }

    /** Converts density per area to density per solid angle; 0 on a side that does not emit, and where it is not finite. */
    static double pdfOfArea(double area, LightSides sides, double distance, double cosine) {
        if (!sides.shineAt(cosine)) {
            return 0;
        }
        double density = distance * distance / (area * Math.abs(cosine));
        return density <= Double.MAX_VALUE ? density : 0;
    }
}
