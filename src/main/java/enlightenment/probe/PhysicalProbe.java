package enlightenment.probe;

import enlightenment.emitter.SampledLight;
import enlightenment.film.SampleLog;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.sampling.SobolSampler;
import enlightenment.transport.direct.LightView;
import enlightenment.transport.direct.NextEventEstimation;
import enlightenment.transport.direct.ShadowRays;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.parts.RayCounters;

/**
 * Of physical shading: S is the first surface that scatters light in more than single directions, behind mirrors and smooth glass, and L
 * a point of a light as {@link NextEventEstimation} draws it there: where it takes all lights, that of light n modulo how many they are in sample n
 * of a pixel, otherwise that of the one that is chosen. Media are looked through.
 */
final class PhysicalProbe extends RayProbe {
    /** As many lights are taken all. */
    private static final int ALL_AT_FIRST = 4;

    private final PhysicalScene physical;
    private final LightView view = new LightView();
    private final SampledLight choice = new SampledLight();
    private final ShadowRays shadow;
    private final double[] pair = new double[2];
    private int address;

    PhysicalProbe(CompiledScene scene) {
        super(scene, scene.physical.maxBounces);
        physical = scene.physical;
        shadow = new ShadowRays(scene, new RayCounters(scene.kindNames.size()), path, view.cone);
    }

    @Override
    void tell(SobolSampler sampler) {
        address = 0;
        if (!follow(sampler)) {
            return;
        }
        if (path.at.emits()) {
            outcome = SampleLog.Outcome.LIGHT_SEEN;
        } else if (!path.at.material.isBlack) {
            askForLight(sampler);
        }
    }

    @Override
    boolean cross(Ray at, SobolSampler sampler) {
        sampler.pair(address, Sampler.Purpose.CHOICE, pair);
        double way = pair[0];
        int opaque = physical.hasPartialGlass ? path.glass.opaque(pair[1]) : -1;
        if (opaque >= 0) {
            path.turnToOpaque(opaque);
            surfaceIsAt(path.at.hit.px, path.at.hit.py, path.at.hit.pz);
            return false;
        }
        if (physical.hasRoughGlass) {
            sampler.pair(address, Sampler.Purpose.DIRECTION, pair);
        }
        address++;
        path.glass.choose(way, pair);
        path.cross(at);
        return true;
    }

    private void askForLight(SobolSampler sampler) {
        PhysicalLight[] lights = physical.lights;
        double nx = path.at.nx;
        double ny = path.at.ny;
        double nz = path.at.nz;
        double x = path.at.hit.px;
        double y = path.at.hit.py;
        double z = path.at.hit.pz;
        int drawn = -1;
        int index = -1;
        if (lights.length <= ALL_AT_FIRST) {
            index = lights.length == 0 ? -1 : sampler.sample() % lights.length;
            drawn = index;
        } else {
            sampler.pair(address, Sampler.Purpose.CHOICE, pair);
            physical.picker.choose(x, y, z, nx, ny, nz, pair[0], choice);
            index = choice.light;
        }
        if (index < 0
                || lights[index].isInPlaneWith(path.at.id, path.at.hit.face)
                || lights[index].isBallOf(path.at.id)) {
            return;
        }
        PhysicalLight l = lights[index];
        if (l.isPoint) {
            view.aimAtPoint(l, x, y, z);
        } else {
            view.aim(l, x, y, z);
            view.draw(drawn, sampler, address);
            view.sample(l.form);
        }
        double cosine = nx * view.sample.dx + ny * view.sample.dy + nz * view.sample.dz;
        if (cosine > 0 && (l.isPoint || view.sample.pdf > 0)) {
            double length = view.sample.length;
            lightIsAt(
                    Math.fma(length, view.sample.dx, x),
                    Math.fma(length, view.sample.dy, y),
                    Math.fma(length, view.sample.dz, z));
            outcome = isVisible(l) ? SampleLog.Outcome.LIT : SampleLog.Outcome.SHADOWED;
        }
    }

    private boolean isVisible(PhysicalLight l) {
        shadow.begin();
        return shadow.isVisible(l, view.sample);
    }
}
