package enlightenment.device;

import enlightenment.accel.PrimitiveList;
import enlightenment.emitter.FlatSampler;
import enlightenment.emitter.ParallelogramLight;
import enlightenment.world.CompiledScene;
import enlightenment.world.light.ClassicLight;
import enlightenment.world.light.PhysicalLight;

/** Writes the lights of a scene, what may occlude each of them, and how one of them is chosen. */
final class LightWriter {
    private static final int NONE = -1;

    /** Numbers of the form of a rectangle, and those of them that stand first: the corner and two edges. */
    private static final int FORM = 21;

    private final CompiledScene scene;
    private final NumberList.Doubles doubles;
    private final NumberList.Ints ints;

    LightWriter(CompiledScene scene, NumberList.Doubles doubles, NumberList.Ints ints) {
        this.scene = scene;
        this.doubles = doubles;
        this.ints = ints;
    }

    void write() {
        NumberList.Ints records = new NumberList.Ints();
        if (scene.physical == null) {
            writeClassic(records);
            set(DeviceScene.Int.LIGHT_COUNT, scene.lights.length);
        } else {
            for (int index = 0; index < scene.physical.lights.length; index++) {
                write(index, records);
            }
            set(DeviceScene.Int.LIGHT_COUNT, scene.physical.lights.length);
            boolean hasPass = scene.physical.hasCausticPass();
            set(DeviceScene.Int.HAS_CAUSTIC_PASS, hasPass ? 1 : 0);
            set(DeviceScene.Int.HAS_MIRROR_BALLS, hasPass && scene.mirrorBalls != null ? 1 : 0);
            writeSampler(scene.physical.picker.flatForm());
        }
        set(DeviceScene.Int.LIGHTS, ints.add(records.toArray()));
    }

    private void set(DeviceScene.Int slot, int value) {
        ints.set(slot.ordinal(), value);
    }

    private void writeClassic(NumberList.Ints records) {
        int seen = 0;
        for (ClassicLight light : scene.lights) {
            int place = doubles.add(light.r, light.g, light.b, light.ballX, light.ballY, light.ballZ, light.ballRadius);
            doubles.add(light.x, light.y, light.z, light.right.x(), light.right.y(), light.right.z());
            doubles.add(light.up.x(), light.up.y(), light.up.z());
            int surface = light.surface == null ? NONE : scene.primitives.length + seen++;
            DeviceScene.Form kind = light.isDelta
                    ? DeviceScene.Form.POINT_LIGHT
                    : light.radius > 0 ? DeviceScene.Form.BALL_LIGHT : DeviceScene.Form.RECTANGLE_LIGHT;
            boolean isSearchedSingly = light.occluders != null && light.occluders.union() == null;
            records.add(kind.ordinal(), surface, place, isSearchedSingly ? 1 : 0, 0, 0, 0, NONE, NONE, 0, 0, 0);
        }
    }

    private void write(int index, NumberList.Ints records) {
        PhysicalLight light = scene.physical.lights[index];
        int place = doubles.add(light.r, light.g, light.b, light.ballX, light.ballY, light.ballZ, light.ballRadius);
        int sides = 0;
        DeviceScene.Form kind = light.isPoint ? DeviceScene.Form.POINT_LIGHT : DeviceScene.Form.BALL_LIGHT;
        if (light.form instanceof ParallelogramLight rectangle) {
            kind = DeviceScene.Form.RECTANGLE_LIGHT;
            sides = rectangle.sides().ordinal();
            doubles.add(rectangle.flatForm());
        } else {
            doubles.add(new double[FORM]);
        }
        double tolerance = light.lyingOn().toleranceIfOnly(light.id, light.face);
        doubles.add(tolerance);
        boolean areFew = light.occluders instanceof PrimitiveList;
        records.add(kind.ordinal(), light.id, place, 0, light.face, sides);
        records.add(
                areFew ? writeOccluders(light, (PrimitiveList) light.occluders) : 0,
                areFew ? ((PrimitiveList) light.occluders).size() : NONE,
                light.pyramid == null ? NONE : doubles.add(light.pyramid.flatForm()),
                light.hidesNothingOfItself ? 1 : 0,
                tolerance >= 0 ? 1 : 0,
                takesNarrow(index) ? 1 : 0);
    }

    private boolean takesNarrow(int light) {
        return scene.physical.hasCausticPass() && scene.physical.caustics.takesNarrow(light);
    }

    private int writeOccluders(PhysicalLight light, PrimitiveList some) {
        NumberList.Ints records = new NumberList.Ints();
        for (int k = 0; k < some.size(); k++) {
            int id = some.members()[k];
            int traits = scene.occluders.isBall(id) ? 1 : 0;
            if (scene.occluders.hasPlane(id)) {
                traits |= 2
                        | (scene.occluders.isOnSide(id, light, true) ? 4 : 0)
                        | (scene.occluders.isOnSide(id, light, false) ? 8 : 0);
            }
            records.add(id, traits, doubles.add(scene.occluders.flatForm(id)));
        }
        return ints.add(records.toArray());
    }

    private void writeSampler(FlatSampler sampler) {
        int n = sampler.indices().length;
        int[] kinds = new int[2 * n];
        for (int place = 0; place < n; place++) {
            kinds[2 * place] = sampler.kinds()[place];
            kinds[2 * place + 1] = sampler.indices()[place];
        }
        set(DeviceScene.Int.PICKER, ints.add(kinds));
        ints.add(sampler.places());
        set(DeviceScene.Int.PICKER_WEIGHTS, doubles.add(sampler.weights()));
        if (sampler.tree() != null) {
            ints.add(sampler.tree().second());
            ints.add(sampler.tree().parents());
            ints.add(sampler.tree().leaves());
            set(DeviceScene.Int.PICKER_TREE, doubles.add(sampler.tree().nodes()));
        }
    }
}
