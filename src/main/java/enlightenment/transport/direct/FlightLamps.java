package enlightenment.transport.direct;

import enlightenment.math.Vec3;
import enlightenment.numeric.Exponential;
import enlightenment.primitive.Ray;
import enlightenment.transport.media.Equiangular;
import enlightenment.world.PhysicalScene;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.material.HomogeneousMedium;

/**
 * Samples a lamp near to a flight through a medium, and a point of the flight by equiangular sampling from that lamp; has the densities of
 * both. A mutable work object of one flight.
 *
 * <p>A lamp is near if its irradiance varies much along the flight: if its least distance is small beside the mean length of free flights,
 * cut off at the surface that the ray hits. Light of other lamps is nearly constant along the flight, and sampled well at the ends of free
 * flights.
 */
final class FlightLamps {
    /** Up to this number of lamps, each is weighed for every flight; beyond, lamps are sampled by intensity alone. */
    private static final int FEW = 16;

    /**
     * With many lamps, none is sampled along flights after this number of scattering events in a row: each such flight must be traced to a
     * surface.
     */
    private static final int OFTEN = 2;

    /**
     * A lamp is near if this multiple of its distance is at most the mean length of free flights. FITTED: 3, 4, 6 and 8 were tried on lamps
     * in thin and dense fog and on rooms in haze (docs/notes/media.md). It changes variance only.
     */
    private static final double NEAR = 6;

    private final PhysicalLight[] lights;

    /** Radiant intensity of each lamp, roughly and summed over bands; beyond {@link #FEW} lamps cumulative sums of these. */
    private final double[] strengths;

    private final double[] weights;

    /** By lamp, its equiangular sampling; a single one beyond {@link #FEW} lamps. */
    private final Equiangular[] points;

    /** The ray of the flight; set only beyond {@link #FEW} lamps. */
    private final Ray ray = new Ray();

    private double length;

    /** The least extinction coefficient of the bands, per length of the frame. */
    private double extinction;

    /** The squared distance within which a lamp is near to the flight. */
    private double near;

    private double sum;

    /**
     * The distance at which the flight scattered the path, and the density of free flights there, per length; density 0 if no lamp was
     * sampled along the flight.
     */
    private double end;

    private double flies;

    /** The index of the sampled lamp. */
    int lamp;

    /** The distance of the sampled point along the flight, in the frame. */
    double distance;

    /** The density of lamp and point: probability of the lamp times density per length. */
    double density;

    FlightLamps(PhysicalScene physical) {
        lights = physical.lights;
        int count = lights.length;
        strengths = new double[count];
        weights = new double[Math.min(count, FEW)];
        points = new Equiangular[count <= FEW ? count : 1];
        for (int i = 0; i < count; i++) {
            strengths[i] = strength(lights[i]) + (count > FEW && i > 0 ? strengths[i - 1] : 0);
        }
        for (int i = 0; i < points.length; i++) {
            points[i] = new Equiangular(Vec3.ZERO);
            see(i);
        }
    }

    /** Radiant intensity of a lamp, roughly and summed over bands: radiance times area if it has extent. */
    private static double strength(PhysicalLight l) {
        double bands = l.meanR + l.meanG + l.meanB + l.meanUltraviolet;
        return l.isPoint ? bands : bands * l.form.area();
    }

    private boolean isMany() {
        return lights.length > FEW;
    }

    private Equiangular see(int i) {
        PhysicalLight l = lights[i];
        Equiangular point = points[isMany() ? 0 : i];
        point.see(l.ballX, l.ballY, l.ballZ, l.ballRadius / 2);
        return point;
    }

    /**
     * Begins a flight along a ray.
     *
     * @param scatterings the number of scattering events in media since the path left the last surface, or the eye
     * @return whether a lamp may be near to it, wherever it ends
     */
    boolean begin(Ray along, HomogeneousMedium medium, int scatterings) {
        flies = 0;
        extinction = Math.min(medium.extinctionR, Math.min(medium.extinctionG, medium.extinctionB));
        reach(Double.POSITIVE_INFINITY);
        if (isMany()) {
            ray.set(along.ox, along.oy, along.oz, along.dx, along.dy, along.dz, along.tMin);
            return scatterings < OFTEN;
        }
        boolean isNear = false;
        for (Equiangular point : points) {
            point.place(along);
            isNear |= isNear(point);
        }
        return isNear;
    }

    private void reach(double way) {
        length = way;
        // About (1 − exp(−extinction · way)) / extinction, which is slower.
        double reach = 1 / (NEAR * (extinction + 1 / way));
        near = reach * reach;
    }

    private boolean isNear(Equiangular point) {
        return point.leastSquare(length) < near;
    }

    /**
     * Sets the length of the flight up to the surface that the ray hits.
     *
     * @param way that length, in the frame; may be infinite
     * @return whether a lamp may be near to the flight
     */
    boolean end(double way) {
        reach(way);
        sum = 0;
        for (int i = 0; i < weights.length && !isMany(); i++) {
            weights[i] = 0;
            if (isNear(points[i])) {
                points[i].aim(way);
                weights[i] = weight(i);
                sum += weights[i];
            }
        }
        return isMany() || sum > 0;
    }

    /**
     * An approximation of the light that a lamp contributes along the flight; attenuated over the straight line from the lamp to the
     * flight's start, the shortest way.
     */
    private double weight(int i) {
        Equiangular point = points[i];
        double w = strengths[i] * point.integral() * Exponential.exp(-extinction * Math.sqrt(point.squareAtStart()));
        return w > 0 && w < Double.POSITIVE_INFINITY ? w : 0;
    }

    /**
     * Samples a lamp and a point of the flight.
     *
     * @param u uniform in 0..1, as v is
     * @return whether there is one
     */
    boolean choose(double u, double v) {
        if (isMany()) {
            chooseOfMany(u);
        } else {
            chooseOfFew(u);
        }
        Equiangular point = aimed(lamp);
        if (point == null) {
            return false;
        }
        boolean isSampled = point.sample(v);
        distance = point.distance;
        density = probability(lamp) * point.density;
        return isSampled;
    }

    /** Samples one of many lamps by intensity alone, without a loop over them; each has a positive probability. */
    private void chooseOfMany(double u) {
        int low = 0;
        int high = strengths.length - 1;
        double strength = u * strengths[high];
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (strength < strengths[middle]) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        lamp = low;
    }

    /** The equiangular sampling of a lamp; null if it is one of many and not near. */
    private Equiangular aimed(int i) {
        if (!isMany()) {
            return points[i];
        }
        Equiangular point = see(i);
        point.place(ray);
        if (!isNear(point)) {
            return null;
        }
        point.aim(length);
        return point;
    }

    private double probability(int i) {
        return isMany()
                ? (strengths[i] - (i > 0 ? strengths[i - 1] : 0)) / strengths[strengths.length - 1]
                : weights[i] / sum;
    }

    private void chooseOfFew(double u) {
        double left = u * sum;
        for (int i = 0; i < weights.length; i++) {
            if (weights[i] > 0) {
                lamp = i;
                if (left < weights[i]) {
                    break;
                }
                left -= weights[i];
            }
        }
    }

    /** Records where the flight has scattered the path, and the density of free flights there, per length. */
    void scatteredAt(double distance, double ofFreeFlights) {
        end = distance;
        flies = ofFreeFlights;
    }

    /** The density with which this lamp's sampling would have chosen the point where the path was scattered, over that of free flights. */
    double ratio(int i) {
        if (!(flies > 0) || !isMany() && weights[i] == 0) {
            return 0;
        }
        Equiangular point = aimed(i);
        double ratio = point == null ? 0 : probability(i) * point.density(end) / flies;
        return ratio > 0 ? ratio : 0;
    }
}
