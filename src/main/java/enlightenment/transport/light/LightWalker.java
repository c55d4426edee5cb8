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
 * Traces light paths from a {@link PathSource}; at each vertex where a lobe other than a delta lobe scatters light they are connected to
 * the eye (J. Arvo, "Backward ray tracing", 1986; P. Dutré, E. Lafortune, Y. Willems, 1993).
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
    private final Scattering scattering = new Scattering();

    /** The power of the path. */
    final CarriedPower carried;

    private final PathState state = new PathState();

    /** The number of surfaces that the path passed straight. */
    private int pieces;

    /** Samples free flights in media that scatter light; null if there are none. */
    private final FreeFlight flight;

    /** Equiangular sampling of points of flights to connect to the eye. */
    private final Equiangular onTheWay;

    /** The length of the flight that the path has covered, in the frame. */
    private double flown;

    /** Whether a point of the flight has been connected to the eye. */
    private boolean isConnected;

    private final RussianRoulette end = new RussianRoulette();

    /** The medium that may scatter the path. */
    private HomogeneousMedium medium;

    /** Whether only caustics are traced: light that mirrors or smooth glass send to a surface first. */
    private final boolean onlyCaustics;

    /** Decides which vertices of the path belong to the caustic pass. */
    final CausticCount caustic;

    /**
     * For one thread.
     *
     * @param seed of all random numbers of these paths, used for nothing else
     * @param width of the whole picture in pixels
     * @param height of the whole picture in pixels
     * @param counters of this thread
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
     * Traces the ray to the next event; returns whether the path goes on. Shading of opaque surfaces stands here, so that the JIT compiler
     * does not inline this method into its caller.
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
        return surface();
    }

    /** Connects the path to the eye from an opaque surface, and scatters it there; returns whether it goes on. */
    private boolean surface() {
        SurfaceMaterial material = path.at.material;
        Bsdf bsdf = path.at.bsdf;
        if (material.isBlack || !caustic.continues(bsdf)) {
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
        return filterAndSurvive(s.valueR, s.valueG, s.valueB) && path.continues();
    }

    /** Whether narrow lobes count as casters of caustics for small lights, if only caustics are traced. */
    boolean takesNarrow() {
        return true;
    }

    /** Called at a vertex that is connected to the eye; returns whether the path goes on. */
    boolean arrive(Bsdf bsdf, Scattering s) {
        connect(bsdf, s, null);
        return true;
    }

    /**
     * Whether a medium scatters the path. In the caustic pass it does only after the first mirror or glass, as paths from the eye sample
     * the light before that; and only at index of refraction 1, where they have next-event estimation.
     */
    boolean isScatteredIn(SurfaceMaterial in) {
        return !onlyCaustics || caustic.counts() && in.indexOfRefraction == 1;
    }

    /**
     * Traces the ray to its next event, through no medium that scatters it.
     *
     * @param in the material of the medium, which may absorb; null for empty space
     */
    PathFollower.Event pass(SurfaceMaterial in) {
        return path.next(ray);
    }

    /**
     * Samples a free flight and traces the ray to its next event; null if the medium scatters the path first, which is then at that point.
     *
     * @param isSeenStraight whether the eye may see points of the medium directly from outside of it
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
            path.stopAt(ray, flight.length - flown, scattering);
            event = null;
        } else {
            flight.pass(flown + path.distance(ray));
        }
        carried.left.filter(flight.weightR, flight.weightG, flight.weightB);
        return event;
    }

    /**
     * Traces the ray by way of an equiangular point, which is connected to the eye in place of the end of the flight: that would be
     * weighted by its inverse squared distance from the eye, with infinite variance if the eye is in the medium.
     */
    private PathFollower.Event flyBy() {
        PathFollower.Event event = path.next(ray, onTheWay.distance);
        if (event != PathFollower.Event.NOTHING) {
            return event;
        }
        flown = onTheWay.distance;
        path.stopAt(ray, flown, scattering);
        flight.reach(flown);
        double scale = 1 / onTheWay.density;
        connect(
                medium.phase,
                scattering,
                null,
                carried.left.red * (flight.weightR * medium.scatteringR * scale),
                carried.left.green * (flight.weightG * medium.scatteringG * scale),
                carried.left.blue * (flight.weightB * medium.scatteringB * scale));
        ray.set(path.at.hit.px, path.at.hit.py, path.at.hit.pz, -scattering.ox, -scattering.oy, -scattering.oz, 0);
        return path.next(ray, flight.length - flown);
    }

    /** Scatters the path in a medium; returns whether it goes on. */
    private boolean inMedium() {
        if (!isConnected) {
            connect(medium.phase, scattering, null);
        }
        medium.phase.sample(scattering, unit(1), unit(2), 0);
        extend(PathEvent.MEDIUM, scattering);
        ray.set(path.at.hit.px, path.at.hit.py, path.at.hit.pz, scattering.ix, scattering.iy, scattering.iz, 0);
        double survival = end.survival(carried.sum(), path.at.hit.px, path.at.hit.py, path.at.hit.pz, isSafe());
        return survives(survival) && path.continues();
    }

    /**
     * Connects the current vertex, on a surface or in a medium, to the eye and adds the path's light.
     *
     * @param tint of transmitted light at a rough interface; null elsewhere
     */
    private void connect(Bsdf bsdf, Scattering s, double[] tint) {
        connect(bsdf, s, tint, carried.left.red, carried.left.green, carried.left.blue);
    }

    /** Connects the current vertex to the eye and adds this light, in place of the path's throughput. */
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

    /** Scatters the path at an interface of glass, or at a thin slab. */
    private boolean glass() {
        boolean continues = true;
        if (physical.hasRoughGlass) {
            if (!onlyCaustics) {
                connectAtInterface();
            } else {
                Bsdf bsdf = path.roughInterface(ray, scattering);
                continues = bsdf == null || caustic.continues(bsdf);
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
            // Passing straight is no event: an object may be cut into any number of pieces. Paths from the eye find
            // this light by shadow
            // rays.
            pieces++;
            carried.left.filter(surface[0], surface[1], surface[2]);
            return path.continues();
        }
        // Shadow rays of paths from the eye find direct light at rough glass, except where its lobes are narrow.
        if (!continues) {
            return false;
        }
        caustic.leave(path.glass.atInterface.delta, path.at.hit, path.glass.atInterface.pdf);
        extend(PathEvent.ROUGH_INTERFACE, path.glass.atInterface);
        return crosses() && path.continues();
    }

    /** Multiplies by the weight of an event at an interface, and plays Russian roulette. */
    private boolean crosses() {
        if (flight == null) {
            return filterAndSurvive(surface[0], surface[1], surface[2]);
        }
        carried.left.filter(surface[0], surface[1], surface[2]);
        double survival = end.survivalAtInterface(surface[0], surface[1], surface[2]);
        return isSafe() || survives(survival);
    }

    private void connectAtInterface() {
        Bsdf bsdf = path.roughInterface(ray, scattering);
        if (bsdf != null) {
            Arrays.fill(surface, 1);
            path.filter(surface);
            path.turnTo(0);
            connect(bsdf, scattering, surface);
        }
    }

    /** Multiplies by the weight of an event, and plays Russian roulette by it as {@link PathValue} does. */
    private boolean filterAndSurvive(double r, double g, double b) {
        carried.left.filter(r, g, b);
        return isSafe() || carried.most() > 0 && survives(PathValue.survival(r, g, b));
    }

    /** Whether the path continues without Russian roulette. */
    private boolean isSafe() {
        return state.eventsForRoulette() < PathValue.ROULETTE_FROM && !carried.isFaint();
    }

    private void extend(PathEvent event, Scattering sampled) {
        if (sampled.delta) {
            state.extendSpecular(-1);
        } else {
            state.extend(event, sampled, false);
        }
    }

    /** Plays Russian roulette after the last event, with this probability of survival. */
    private boolean survives(double survival) {
        if (!(numbers.unit(state.events - 1, pieces, 4) < survival)) {
            return false;
        }
        carried.left.scale(1 / survival);
        return true;
    }
}
