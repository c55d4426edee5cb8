package enlightenment.importer.mitsuba;

import enlightenment.importer.support.Affine;
import enlightenment.importer.support.PlacedShapes;
import enlightenment.math.Vec3;
import java.util.List;

/**
 * How a scene is turned or mirrored as a whole. Our skies and panoramas have +y upwards, and azimuths grow to the right, as it is in left-handed
 * coordinates; Mitsuba's are right-handed. So what is surrounded by a picture is mirrored, and turned if the picture stands on its side; other scenes
 * stay as they are.
 */
final class WorldMap {
    private static final Affine MIRROR = Affine.scale(-1, 1, 1);
    private static final Vec3 ORIGIN = new Vec3(0, 0, 0);

    private WorldMap() {}

    /** The map from the coordinates of the file to those of the scene. */
    static Affine of(SceneIndex scene, List<XmlElement> elements) {
        for (XmlElement e : elements) {
            if (e.tag().equals("emitter") && e.type().equals("envmap")) {
                return picture(scene, e);
            }
        }
        for (XmlElement e : elements) {
            if (e.tag().equals("emitter") && e.type().matches("sun|sky|sunsky")) {
                return sky(scene, new Properties(e).transform("to_world"));
            }
        }
        boolean isParallel = elements.stream().anyMatch(e -> e.tag().equals("sensor") && SensorReader.isParallel(e));
        return isParallel ? MIRROR : Affine.IDENTITY;
    }

    private static Affine picture(SceneIndex scene, XmlElement e) {
        Affine map = new Properties(e).transform("to_world");
        if (!PlacedShapes.isSimilarity(map)) {
            scene.note(e, "a picture around the scene that is stretched is only turned");
        }
        Vec3 up = map.column(1).normalized();
        boolean isMirrored = map.determinant() < 0;
        if (up.equals(Vec3.Y)) {
            return isMirrored ? Affine.IDENTITY : MIRROR;
        }
        return MIRROR.after(turned(map));
    }

    /** The inverse of the turning of a map. */
    private static Affine turned(Affine map) {
        Vec3 y = map.column(1).normalized();
        Vec3 x = y.cross(map.column(2)).normalized();
        Vec3 z = x.cross(y);
        double side = map.determinant() < 0 ? -1 : 1;
        // The transpose of a rotation is its inverse.
        return new Affine(x.times(side), y, z, ORIGIN);
    }

    /** Mitsuba 3 has z upwards in skies, 0.6 y. */
    private static Affine sky(SceneIndex scene, Affine map) {
        Vec3 up = map.column(scene.isOld() ? 1 : 2).normalized();
        if (up.equals(Vec3.Y)) {
            return Affine.IDENTITY;
        }
        Vec3 other = StrictMath.abs(up.x()) < StrictMath.abs(up.z()) ? Vec3.X : Vec3.Z;
        Vec3 x = up.cross(other).normalized();
        return new Affine(x, up, x.cross(up), ORIGIN);
    }
}
