package enlightenment.transport.direct;

import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.transport.media.Equiangular;
import enlightenment.world.PhysicalScene;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.material.HomogeneousMedium;

/**
 * The lamps that a flight through a medium comes near: chooses one of them, and a point of the flight equiangularly as seen from there; and
 * knows the density with which it would have chosen another. A mutable work object of one flight.
 *
 * <p>A lamp is near if light of it differs much along the flight: if the least distance from it is small beside the length that free flights
 * have in the mean, which end at the surface that is met. Light of other lamps is nearly even there, and sampled well where flights end.
 */
final class FlightLamps {
    /** Up to this number every lamp is weighed for every flight. */
    private static final int FEW = 16;

    /** From so many scatterings in a row on, many lamps are not worth the time of following each flight to a surface. */
    private static final int OFTEN = 2;

    /**
     * A lamp is near if so many of its distances are no longer than free flights in the mean. FITTED: 3, 4, 6 and 8 were tried on lamps in
     * thin and dense fog and on rooms in haze (docs/notes/media.md). It decides about noise only.
     */
    private static final double NEAR = 6;

    private final PhysicalLight[] lights;

    /** About the radiant intensities of lamps; if there are many, of each those of it and of all before it. */
    private final double[] strengths;

    private final double[] weights;

    /** For each lamp, if there are few; one for all if there are many. */
    private final Equiangular[] points;

    /** The flight, if there are many. */
    private final Ray ray = new Ray();

    private double length;

    /** The least over the bands. */
    private double extinction;

    /** Within what distance a lamp is near to the flight; squared. */
    private double near;

    private double sum;

    /** Where the flight scattered the path, and with what density, per length; 0 if nothing was chosen along the flight. */
    private double end;

    private double flies;

    /** The lamp that was chosen. */
    int lamp;

    /** The point of the flight that was chosen for it: how far along. */
    double distance;

    /** The density of the choice of both, per length. */
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

    /** About the radiant intensity of a lamp, summed over bands. */
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
     * @param scatterings how often media have scattered the path since it left the last surface, or the eye
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
        // Roughly (1 − exp(−extinction · way)) / extinction, which takes longer to tell.
        double reach = 1 / (NEAR * (extinction + 1 / way));
        near = reach * reach;
    }

    private boolean isNear(Equiangular point) {
        return point.leastSquare(length) < near;
    }

    /**
     * Goes on to what the ray meets.
     *
     * @param way the length up to there, in lengths of the frame; may be infinite
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

    /** What comes from a lamp, roughly: none of it went a shorter way than straight. */
    private double weight(int i) {
        Equiangular point = points[i];
        double w = strengths[i] * point.integral() * StrictMath.exp(-extinction * Math.sqrt(point.squareAtStart()));
        return w > 0 && w < Double.POSITIVE_INFINITY ? w : 0;
    }

    /**
     * Chooses a lamp and a point of the flight.
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
        boolean isThere = point.sample(v);
        distance = point.distance;
        density = probability(lamp) * point.density;
        return isThere;
    }

    /** Of many lamps by strength alone: it takes no look at them all, and leaves none out. */
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

    /** What chooses points for a lamp; null if that is one of many, and not near. */
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

    /** The flight has scattered the path at this distance, for which free flights have this density. */
    void scatteredAt(double distance, double ofFreeFlights) {
        end = distance;
        flies = ofFreeFlights;
    }

    /** The density with which the point where the path was scattered would have been chosen for this lamp, over that of free flights. */
    double ratio(int i) {
        if (!(flies > 0) || !isMany() && weights[i] == 0) {
            return 0;
        }
        Equiangular point = aimed(i);
        double ratio = point == null ? 0 : probability(i) * point.density(end) / flies;
        return ratio > 0 ? ratio : 0;
    }
}
