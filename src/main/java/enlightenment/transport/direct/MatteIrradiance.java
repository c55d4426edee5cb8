package enlightenment.transport.direct;

import enlightenment.emitter.LightSample;
import enlightenment.emitter.SphereLight;
import enlightenment.sampling.Sampler;
import enlightenment.transport.state.PowerHeuristic;
import enlightenment.world.Tracer;
import enlightenment.world.light.LightCone;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.parts.RayCounters;

/**
 * Irradiance of a light at a Lambertian vertex: by its closed form where nothing can occlude it, else by a sampled point, with the MIS
 * weight against cosine-weighted BSDF samples. Mutable, one per thread.
 */
final class MatteIrradiance {
    private final RayCounters counters;
    private final ShadowRays shadow;
    private final LightView view;
    private final LightCone cone;
    private final LightSample sample;

    private final LitVertex lit;

    /** Whether the last irradiance is no deterministic function of film position: random, or varying between corners of a pixel. */
    boolean isByChance;

    /**
     * @param view the light as the vertex sees it; shadow rays use its cone
     * @param lit the vertex, which the caller sets
     */
    MatteIrradiance(RayCounters counters, ShadowRays shadow, LightView view, LitVertex lit) {
        this.lit = lit;
        this.counters = counters;
        this.shadow = shadow;
        this.view = view;
        cone = view.cone;
        sample = view.sample;
    }

    /**
     * Estimates the irradiance of a light of radiance 1, or intensity 1 for a point light, times its MIS weight.
     *
     * @param index of the light where several are sampled, for its random numbers; -1 where one was sampled
     * @param probability of that choice
     */
    double of(PhysicalLight l, int index, double probability, Sampler sampler, int address) {
        // A profile depends on the direction from the light, so that it varies between pixel corners just as random
        // samples do.
        isByChance = index < 0 || l.profile != null;
        double e = l.isPoint ? ofPoint(l) : irradiance(l, index, probability, sampler, address);
        // Attenuated light is deterministic, but it varies between pixel corners as well.
        isByChance |= shadow.isFiltered;
        return e;
    }

    private double ofPoint(PhysicalLight l) {
        view.aimAtPoint(l, lit.x, lit.y, lit.z);
        double cosine = lit.nx * cone.wx + lit.ny * cone.wy + lit.nz * cone.wz;
        return cosine > 0 && shadow.isVisible(l, sample) ? cosine / (cone.distance * cone.distance) : 0;
    }

    private double irradiance(PhysicalLight l, int index, double probability, Sampler sampler, int address) {
        if (l.isBall && l.texture == null) {
            return ofBall(l, index, probability, sampler, address);
        }
        view.aim(l, lit.x, lit.y, lit.z);
        // Skips the closed form where it is 0.
        if (!view.reaches(l.form, lit.nx, lit.ny, lit.nz)) {
            counters.lightSamplesWithoutRay++;
            return 0;
        }
        Tracer.Visibility known = shadow.visibility(l);
        if (known == Tracer.Visibility.NONE) {
            counters.lightSamplesWithoutRay++;
            return 0;
        }
        if (known == Tracer.Visibility.ALL && l.texture == null && l.form.hasClosedForm()) {
            counters.lightSamplesWithoutRay++;
            return view.irradiance(l.form, lit.nx, lit.ny, lit.nz);
        }
        return sampled(l, index, probability, sampler, address, known);
    }

    /**
     * Irradiance of a sphere light: its closed form times the visibility of one point, sampled by the cosine if the whole sphere is above
     * the horizon; if the horizon cuts it, by a point sampled uniformly. Too long for the JIT compiler to inline into its callers, which
     * costs nothing (docs/notes/benchmarks.md).
     */
    private double ofBall(PhysicalLight l, int index, double probability, Sampler sampler, int address) {
        SphereLight ball = (SphereLight) l.form;
        ball.aim(sample, lit.x, lit.y, lit.z);
        cone.around(l);
        if (cone.inside) {
            Tracer.Visibility known = shadow.visibility(l);
            return known == Tracer.Visibility.NONE ? 0 : sampled(l, index, probability, sampler, address, known);
        }
        double height = lit.nx * cone.wx + lit.ny * cone.wy + lit.nz * cone.wz;
        boolean isWhole = height >= cone.sine;
        double e = isWhole ? Math.PI * height * cone.sine * cone.sine : ball.irradiance(sample, lit.nx, lit.ny, lit.nz);
        Tracer.Visibility known = e == 0 ? Tracer.Visibility.NONE : shadow.visibility(l);
        if (known != Tracer.Visibility.UNKNOWN) {
            counters.lightSamplesWithoutRay++;
            return known == Tracer.Visibility.ALL ? e : 0;
        }
        isByChance = true;
        view.draw(index, sampler, address);
        if (isWhole) {
            view.directByCosine(ball, lit.nx, lit.ny, lit.nz);
            return shadow.isBlocked(l, sample) ? 0 : e;
        }
        view.sample(ball);
        double cosine = lit.nx * sample.dx + lit.ny * sample.dy + lit.nz * sample.dz;
        return cosine > 0 && sample.pdf > 0 && !shadow.isBlocked(l, sample) ? cosine / sample.pdf : 0;
    }

    /** Irradiance by a sampled point of the light, with the MIS weight against cosine-weighted BSDF samples. */
    private double sampled(
            PhysicalLight l, int index, double probability, Sampler sampler, int address, Tracer.Visibility known) {
        isByChance = true;
        view.draw(index, sampler, address);
        view.sample(l.form);
        double cosine = lit.nx * sample.dx + lit.ny * sample.dy + lit.nz * sample.dz;
        if (!(sample.pdf > 0) || !(cosine > 0)) {
            counters.lightSamplesWithoutRay++;
            return 0;
        }
        double weighed = cosine / sample.pdf * PowerHeuristic.weight(cosine / Math.PI, probability * sample.pdf);
        if (known != Tracer.Visibility.ALL && shadow.isBlocked(l, sample)) {
            return 0;
        }
        if (l.texture != null) {
            shadow.weighByTexture(l, sample);
        }
        return weighed;
    }

    /** Whether the matte vertex takes all of the light from its closed form, so that BSDF samples that hit it have weight 0. */
    boolean isClosed(PhysicalLight l) {
        if (l.texture != null) {
            return false;
        }
        if (l.isBall) {
            return l.form.irradiance(sample, lit.nx, lit.ny, lit.nz) > 0;
        }
        return l.form.hasClosedForm()
                && view.reaches(l.form, lit.nx, lit.ny, lit.nz)
                && shadow.visibility(l) != Tracer.Visibility.UNKNOWN;
    }
}
