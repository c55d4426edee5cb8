package enlightenment.transport.bidirectional;

import enlightenment.bsdf.Scattering;
import enlightenment.emitter.LightSample;
import enlightenment.emitter.LightSampler;
import enlightenment.emitter.SampledLight;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.direct.LightView;
import enlightenment.transport.direct.ShadowRays;
import enlightenment.transport.ray.Optics;
import enlightenment.world.CompiledScene;
import enlightenment.world.LightStarts;
import enlightenment.world.PhysicalScene;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.parts.RayCounters;

/**
 * The bidirectional strategies of an eye subpath that samples a point of a light (next-event estimation) or hits a light: their
 * contributions and MIS weights.
 */
final class BidirectionalLights {
    private final PhysicalScene physical;
    private final LightSampler picker;
    private final LightStarts starts;
    private final RayCounters counters;
    private final EyeSubpath eye;
    private final ShadowRays shadow;
    private final LightView view = new LightView();
    private final LightSample sample = view.sample;
    private final SampledLight choice = new SampledLight();
    private final double[] pair = new double[2];

    /** The estimate of next-event estimation, without its weight: radiance towards the path's previous vertex. */
    double red;

    double green;
    double blue;
    double ultraviolet;

    double weight;

    BidirectionalLights(CompiledScene scene, LightStarts starts, RayCounters counters, EyeSubpath eye) {
        physical = scene.physical;
        picker = physical.picker;
        this.starts = starts;
        this.counters = counters;
        this.eye = eye;
        shadow = new ShadowRays(scene, counters, eye.path, view.cone);
    }

    /** The index of the sampled light. */
    int light() {
        return choice.light;
    }

    /** The sampled point of the light. */
    LightSample sample() {
        return sample;
    }

    /** The MIS weight of hitting a light at a vertex that is not the path's first. */
    double weightOfHit() {
        Hit hit = eye.path.at.hit;
        int index = eye.path.at.light;
        if (index < 0) {
            return 1;
        }
        Scattering s = eye.s;
        double cosine = s.ox * s.nx + s.oy * s.ny + s.oz * s.nz;
        double outside = hit.side == Ray.OUTSIDE ? cosine : -cosine;
        double aimed = eye.state.hasDirect ? aimed(index, hit, outside) : 0;
        double ofLight = aimed > 0 ? SubpathDensities.square(aimed) * eye.densities.edge : 0;
        double emission = emission(index, outside);
        double ofPath = emission > 0 ? SubpathDensities.square(emission) * eye.densities.beyond : 0;
        return SubpathDensities.weight(ofLight, ofPath);
    }

    /** The density, per area of the light in {@link PhysicalScene#areaUnit}s, with which the last vertex would have sampled this point. */
    private double aimed(int index, Hit hit, double cosine) {
        PhysicalLight l = physical.lights[index];
        if (l.isBallOf(eye.lastId)) {
            return 0;
        }
        view.aim(l, eye.lastX, eye.lastY, eye.lastZ);
        double x = hit.px - eye.lastX;
        double y = hit.py - eye.lastY;
        double z = hit.pz - eye.lastZ;
        double d2 = x * x + y * y + z * z;
        double d = Math.sqrt(d2);
        double density = l.form.pdf(sample, x / d, y / d, z / d, d, cosine);
        if (!(density > 0)) {
            return 0;
        }
        double probability =
                picker.probability(index, eye.lastX, eye.lastY, eye.lastZ, eye.lastNx, eye.lastNy, eye.lastNz, choice);
        return probability * density * Math.abs(cosine) / (d2 / physical.areaUnit);
    }

    /** The density, per area in {@link PhysicalScene#areaUnit}s and solid angle, with which light paths leave a light with extent. */
    private double emission(int index, double outside) {
        double cosine =
                starts.shinesBothWays(index) ? Math.abs(outside) : starts.shinesInwards(index) ? -outside : outside;
        double perArea = starts.pointDensity(index) * physical.areaUnit;
        return starts.probability(index) * perArea * starts.directionDensity(index, cosine);
    }

    /**
     * Samples a light from the current vertex of the eye subpath.
     *
     * @return whether light arrives
     */
    boolean aim(Sampler sampler) {
        Hit hit = eye.path.at.hit;
        Scattering s = eye.s;
        double side = eye.isInterface ? 0 : 1;
        sampler.pair(eye.state.address, Sampler.Purpose.CHOICE, pair);
        picker.choose(hit.px, hit.py, hit.pz, side * s.nx, side * s.ny, side * s.nz, pair[0], choice);
        if (choice.light < 0) {
            return false;
        }
        PhysicalLight l = physical.lights[choice.light];
        if (eye.leavesLight(choice.light) || l.isInPlaneWith(eye.path.at.id, hit.face) || l.isBallOf(eye.path.at.id)) {
            return false;
        }
        counters.lightSamples++;
        double density = choice.probability * density(l, sampler);
        if (!(density > 0)) {
            return false;
        }
        s.ix = sample.dx;
        s.iy = sample.dy;
        s.iz = sample.dz;
        eye.bsdf.evaluate(s);
        shadow.isFiltered = false;
        if (eye.isInterface) {
            shadow.beginAtInterface(Optics.turn(s, eye.color));
        } else {
            shadow.begin();
        }
        if (!(s.valueR > 0 || s.valueG > 0 || s.valueB > 0) || !shadow.isVisible(l, sample)) {
            return false;
        }
        red = s.valueR * l.r / density;
        green = s.valueG * l.g / density;
        blue = s.valueB * l.b / density;
        ultraviolet = s.valueB * l.ultraviolet / density;
        if (shadow.isFiltered) {
            red *= shadow.rgb[0];
            green *= shadow.rgb[1];
            blue *= shadow.rgb[2];
            ultraviolet *= shadow.rgb[2];
        }
        weigh(l, density);
        return true;
    }

    /** Samples a point of the light; returns its density per solid angle or, of a point light, the squared distance. */
    private double density(PhysicalLight l, Sampler sampler) {
        Hit hit = eye.path.at.hit;
        if (l.isPoint) {
            view.aimAtPoint(l, hit.px, hit.py, hit.pz);
            return view.cone.distance * view.cone.distance;
        }
        view.aim(l, hit.px, hit.py, hit.pz);
        view.draw(-1, sampler, eye.state.address);
        view.sample(l.form);
        return sample.pdf;
    }

    private void weigh(PhysicalLight l, double density) {
        Scattering s = eye.s;
        double here = eye.projected(s.geometricCosineIn());
        double there = l.isPoint ? 1 : Math.abs(sample.cosine);
        double run = l.isPoint ? 0 : eye.survival * s.pdf / density;
        double ofLight = SubpathDensities.square(run);
        double emission = l.isPoint
                ? starts.probability(choice.light)
                        * physical.areaUnit
                        * starts.directionDensity(choice.light, -sample.dx, -sample.dy, -sample.dz)
                : emission(choice.light, sample.cosine);
        double ofEye = emission > 0
                ? SubpathDensities.square(emission * here / (density * there))
                        * eye.densities.behind(eye.survival * eye.reverse.of(eye.bsdf, s))
                : 0;
        weight = SubpathDensities.weight(ofLight, ofEye);
    }
}
