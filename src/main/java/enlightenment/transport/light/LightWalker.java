package enlightenment.transport.light;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Ray;
import enlightenment.transport.emission.LightPathNumbers;
import enlightenment.transport.media.Equiangular;
import enlightenment.transport.media.FreeFlight;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.ray.PathSource;
import enlightenment.transport.state.PathEvent;
import enlightenment.transport.state.PathState;
import enlightenment.transport.state.PathValue;
import enlightenment.transport.state.PathWavelength;
import enlightenment.transport.state.RussianRoulette;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.material.HomogeneousMedium;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;

/**
 * Follows paths of light from where a {@link PathSource} starts them; at each surface that scatters light other than into single
 * directions they are connected to the eye (J. Arvo, "Backward ray tracing", 1986; P. Dutré, E. Lafortune, Y. Willems, 1993).
 *
 * <p>Light paths carry power, not radiance: at an interface there is no factor (n/n')² ({@code Scattering.radiance} is false).
 */
abstract class LightWalker extends LightPathTracer {
    final PhysicalScene physical;
    final PathSource source;
    final Ray ray = new Ray();

    private final PathWavelength wavelength;
    private final LightPathNumbers numbers;
    private final double[] surface = new double[3];
    private final double[] pair = new double[2];
    private final Scattering border = new Scattering();

    /** The power that the path carries. */
    final CarriedPower carried;

    private final PathState state = new PathState();

    /** How many surfaces it passed straight. */
    private int pieces;

    /** How the path flies through media that scatter light; null if there are none. */
    private final FreeFlight flight;

    /** Chooses the points of flights that are connected to the eye. */
    private final Equiangular onTheWay;

    /** How much of the flight the path has behind it. */
    private double flown;

    /** Whether a point of the flight has been connected to the eye. */
    private boolean isConnected;

    private final RussianRoulette end = new RussianRoulette();

    /** The medium that scatters the path. */
    private HomogeneousMedium medium;

    /** Whether only light counts that mirrors or smooth glass send to a surface first: the rest is found by others. */
    private final boolean onlyCaustics;

    /** Which part of the path's light counts. */
    final CausticCount caustic;

    /**
     * For one thread.
     *
     * @param seed of all random numbers of these paths, and of no others
     * @param width of the whole picture in pixels
     * @param height of the whole picture in pixels
     * @param counters what this thread counts
     */
    LightWalker(
            CompiledScene scene,
            PathSource source,
            boolean onlyCaustics,
            long seed,
            int width,
            int height,
            RayCounters counters) {
        super(scene, new PathFollower(scene, counters, scene.physical.maxBounces), width, height, counters);
        numbers = new LightPathNumbers(seed);
        this.source = source;
        this.onlyCaustics = onlyCaustics;
        physical = scene.physical;
        caustic = new CausticCount(onlyCaustics ? physical.caustics : null, takesNarrow());
        wavelength = path.glass.wavelength;
        carried = new CarriedPower(physical.visibleOfUltraviolet);
        flight = physical.hasScattering ? new FreeFlight() : null;
        onTheWay = eye.sampling();
    }

    @Override
    boolean follow(long number) {
        numbers.begin(number);
        if (wavelength != null) {
            wavelength.begin(numbers.wavelength());
        }
        if (!source.emit(numbers.first, ray)) {
            return false;
        }
        carried.begin(source);
        state.begin();
        pieces = 0;
        caustic.begin(source.light);
        path.beginAtLight(ray, source);
        end.begin();
        if (flight != null) {
            flight.begin();
        }
        while (step()) {}
        return true;
    }

    @Override
    double power() {
        return source.power(physical.visibleOfUltraviolet);
    }

    private double unit(long purpose) {
        return numbers.unit(state.events, pieces, purpose);
    }

    /**
     * Follows the ray to the next event; returns whether the path goes on. What happens at opaque surfaces stands here, so that this is too
     * long to be compiled again into its caller.
     */
    private boolean step() {
        if (wavelength != null && wavelength.takesEffect()) {
            carried.left.filter(wavelength.red, wavelength.green, wavelength.blue);
        }
        SurfaceMaterial in = physical.hasAbsorption ? path.medium() : null;
        medium = in != null && isScatteredIn(in) ? in.medium : null;
        PathFollower.Event event = medium == null ? pass(in) : fly(in.indexOfRefraction == 1);
        if (event == PathFollower.Event.NOTHING || !path.mayScatter()) {
            return false;
        }
        if (event == null) {
            return inMedium();
        }
        if (medium == null && in != null && in.absorbs) {
            Arrays.fill(surface, 1);
            in.absorb(path.distance(ray), surface);
            carried.left.filter(surface[0], surface[1], surface[2]);
        }
        if (event == PathFollower.Event.GLASS) {
            int opaque = physical.hasPartialGlass ? path.glass.opaque(unit(5)) : -1;
            if (opaque < 0) {
                return glass();
            }
            path.turnToOpaque(opaque);
        }
        if (flight != null) {
            flight.begin();
        }
        SurfaceMaterial material = path.at.material;
        Bsdf bsdf = path.at.bsdf;
        if (material.isBlack || !caustic.goesOn(bsdf)) {
            return false;
        }
        path.color(material, surface);
        if (material.reradiation != null && !carried.reradiate(material.reradiation, surface)) {
            return false;
        }
        Scattering s = path.arrive(ray, surface);
        if (caustic.countsAt(bsdf) && !arrive(bsdf, s)) {
            return false;
        }
        if (!bsdf.sample(s, unit(1), unit(2), unit(3)) || !caustic.countsBeyond(bsdf, s.delta)) {
            return false;
        }
        caustic.leave(s.delta, path.at.hit, s.pdf);
        extend(PathEvent.WIDE, s);
        path.leave(ray, s);
        return filterAndSurvive(s.valueR, s.valueG, s.valueB) && path.goesOn();
    }

    /** Whether narrow lobes make caustics of small lights, where only caustics count. */
    boolean takesNarrow() {
        return true;
    }

    /** At a surface that scatters light other than into single directions; returns whether the path goes on. */
    boolean arrive(Bsdf bsdf, Scattering s) {
        connect(bsdf, s, null);
        return true;
    }

    /**
     * Whether a medium scatters the path. Of what makes caustics, light that media scatter before the first mirror or glass is found by
     * paths from the eye, and so is all that is scattered where no lamp is sampled from.
     */
    boolean isScatteredIn(SurfaceMaterial in) {
        return !onlyCaustics || caustic.counts() && in.indexOfRefraction == 1;
    }

    /**
     * Follows the ray to what it meets next, where no medium scatters it.
     *
     * @param in what fills the way, dimming the path if it does; null for empty space
     */
    PathFollower.Event pass(SurfaceMaterial in) {
        return path.next(ray);
    }

    /**
     * Follows the ray to what it meets next; null if the medium that it is in scatters it first: then the path is there.
     *
     * @param isSeenStraight whether the eye may see what the medium scatters from outside of it
     */
    private PathFollower.Event fly(boolean isSeenStraight) {
        end.depart(carried.sum());
        flight.draw(medium, carried.left.red, carried.left.green, carried.blueAndBeyond(), unit(6), unit(7));
        flown = 0;
        isConnected = isSeenStraight && path.mayScatter() && onTheWay.sample(ray, flight.length, unit(8));
        PathFollower.Event event = isConnected ? flyBy() : path.next(ray, flight.length);
        boolean isNothing = event == PathFollower.Event.NOTHING;
        if (isNothing && flight.isEndless()) {
            return event;
        }
        if (isNothing) {
            flight.scatter();
            path.stopAt(ray, flight.length - flown, border);
            event = null;
        } else {
            flight.pass(flown + path.distance(ray));
        }
        carried.left.filter(flight.weightR, flight.weightG, flight.weightB);
        return event;
    }

    /**
     * Follows the ray by way of a point that is connected to the eye, in place of that where the flight ends: there it would count by the
     * inverse square of its distance from the eye, whose variance is infinite with an eye in the medium.
     */
    private PathFollower.Event flyBy() {
        PathFollower.Event event = path.next(ray, onTheWay.distance);
        if (event != PathFollower.Event.NOTHING) {
            return event;
        }
        flown = onTheWay.distance;
        path.stopAt(ray, flown, border);
        flight.reach(flown);
        double scale = 1 / onTheWay.density;
        connect(
                medium.phase,
                border,
                null,
                carried.left.red * (flight.weightR * medium.scatteringR * scale),
                carried.left.green * (flight.weightG * medium.scatteringG * scale),
                carried.left.blue * (flight.weightB * medium.scatteringB * scale));
        ray.set(path.at.hit.px, path.at.hit.py, path.at.hit.pz, -border.ox, -border.oy, -border.oz, 0);
        return path.next(ray, flight.length - flown);
    }

    /** Where a medium scatters the path. */
    private boolean inMedium() {
        if (!isConnected) {
            connect(medium.phase, border, null);
        }
        medium.phase.sample(border, unit(1), unit(2), 0);
        extend(PathEvent.MEDIUM, border);
        ray.set(path.at.hit.px, path.at.hit.py, path.at.hit.pz, border.ix, border.iy, border.iz, 0);
        double survival = end.survival(carried.sum(), path.at.hit.px, path.at.hit.py, path.at.hit.pz, isSafe());
        return survives(survival) && path.goesOn();
    }

    /**
     * Adds what the eye sees of the path's light at the surface, or at the point of a medium, that it is at.
     *
     * @param tint of what passes, at a rough border; null elsewhere
     */
    private void connect(Bsdf bsdf, Scattering s, double[] tint) {
        connect(bsdf, s, tint, carried.left.red, carried.left.green, carried.left.blue);
    }

    /** The same of other light than the path carries. */
    private void connect(Bsdf bsdf, Scattering s, double[] tint, double r, double g, double b) {
        if (eye.hasSeveralStarts()) {
            eye.sampleStart(unit(9), unit(10));
        }
        if (isSeen(bsdf, s, tint)) {
            if (tint != null && wavelength != null) {
                wavelength.color(s);
            }
            double importance = eye.importance();
            add(
                    r * s.valueR * importance * eye.through[0],
                    g * s.valueG * importance * eye.through[1],
                    b * s.valueB * importance * eye.through[2]);
        }
    }

    /** At a border of glass, or at a pane. */
    private boolean glass() {
        boolean goesOn = true;
        if (physical.hasRoughGlass) {
            if (!onlyCaustics) {
                connectAtBorder();
            } else {
                Bsdf bsdf = path.roughBorder(ray, border);
                goesOn = bsdf == null || caustic.goesOn(bsdf);
            }
            pair[0] = unit(1);
            pair[1] = unit(2);
        }
        path.glass.choose(unit(3), pair);
        boolean through = path.cross(ray);
        Arrays.fill(surface, path.glass.weight());
        if (through) {
            path.filter(surface);
        }
        if (path.glass.passedStraight()) {
            // No event: a path may be cut into any number of pieces. Paths from the eye find such light by shadow rays.
            pieces++;
            carried.left.filter(surface[0], surface[1], surface[2]);
            return path.goesOn();
        }
        // Light that comes to rough glass straight is found there by shadow rays, but where its lobes are narrow.
        if (!goesOn) {
            return false;
        }
        caustic.leave(path.glass.border.delta, path.at.hit, path.glass.border.pdf);
        extend(PathEvent.ROUGH_BORDER, path.glass.border);
        return crosses() && path.goesOn();
    }

    /** Multiplies by the weight of an event at a border, and plays roulette. */
    private boolean crosses() {
        if (flight == null) {
            return filterAndSurvive(surface[0], surface[1], surface[2]);
        }
        carried.left.filter(surface[0], surface[1], surface[2]);
        double survival = end.survivalAtBorder(surface[0], surface[1], surface[2]);
        return isSafe() || survives(survival);
    }

    private void connectAtBorder() {
        Bsdf bsdf = path.roughBorder(ray, border);
        if (bsdf != null) {
            Arrays.fill(surface, 1);
            path.filter(surface);
            path.turnTo(0);
            connect(bsdf, border, surface);
        }
    }

    /** Multiplies by the weight of an event, and plays roulette by it as {@link PathValue} does. */
    private boolean filterAndSurvive(double r, double g, double b) {
        carried.left.filter(r, g, b);
        return isSafe() || carried.most() > 0 && survives(PathValue.survival(r, g, b));
    }

    /** Whether nothing asks for an end of the path. */
    private boolean isSafe() {
        return state.events < PathValue.ROULETTE_FROM && !carried.isFaint();
    }

    private void extend(PathEvent event, Scattering sampled) {
        if (sampled.delta) {
            state.extendSpecular(-1);
        } else {
            state.extend(event, sampled, false);
        }
    }

    /** Plays roulette after the last event with a probability of survival. */
    private boolean survives(double survival) {
        if (!(numbers.unit(state.events - 1, pieces, 4) < survival)) {
            return false;
        }
        carried.left.scale(1 / survival);
        return true;
    }
}
