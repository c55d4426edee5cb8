package enlightenment.transport.bidirectional;

import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.media.FreeFlight;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.Throughput;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.material.SurfaceMaterial;
import java.util.Arrays;

/** The throughput of a {@link Subpath} from surface to surface, and its attenuation by media on the way. One per thread. */
abstract class CarriedLight {
    public final PathFollower path;
    final PhysicalScene physical;
    final Ray ray = new Ray();

    /** The throughput of the subpath. */
    public final Throughput throughput;

    /** Flights through media that scatter light; null if there are none. */
    final MediumVertex inMedium;

    /** Whether the path is at a point of such a medium. */
    boolean isMedium;

    private final boolean absorbs;
    private final double[] left = new double[3];

    /**
     * @param path follows the subpath
     * @param flying the purpose of the random numbers of flights
     */
    CarriedLight(CompiledScene scene, PathFollower path, Throughput throughput, Sampler.Purpose flying) {
        this.throughput = throughput;
        this.path = path;
        physical = scene.physical;
        absorbs = physical.hasAbsorption;
        inMedium = physical.hasScattering ? new MediumVertex(path, flying) : null;
    }

    /** Traces the ray to its next event, or to where a medium scatters the path: then this is null, and {@link #isMedium} is set. */
    final PathFollower.Event meet(Sampler sampler) {
        isMedium = false;
        SurfaceMaterial medium = absorbs ? path.medium() : null;
        if (medium != null && medium.medium != null) {
            return fly(medium, sampler);
        }
        PathFollower.Event event = path.next(ray);
        if (event != PathFollower.Event.NOTHING && medium != null && medium.absorbs) {
            Arrays.fill(left, 1);
            medium.absorb(path.distance(ray), left);
            throughput.filter(left[0], left[1], left[2]);
        }
        return event;
    }

    private PathFollower.Event fly(SurfaceMaterial medium, Sampler sampler) {
        PathFollower.Event event = inMedium.fly(ray, medium, throughput, sampler);
        FreeFlight flight = inMedium.flight;
        throughput.filter(flight.weightR, flight.weightG, flight.weightB);
        isMedium = event == null;
        return event;
    }

    /**
     * The factor from a density per solid angle to one of the current vertex: the cosine there, or {@link MediumVertex#density} in a
     * medium.
     */
    public final double projected(double cosine) {
        return isMedium ? inMedium.density() : Math.abs(cosine);
    }

    /** Whether next-event estimation applies at the current vertex. */
    final boolean seesLamps() {
        return !isMedium || inMedium.index() == 1 || physical.lightsLieInGlass;
    }
}
