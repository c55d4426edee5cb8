package enlightenment.text;

import java.util.Arrays;
import java.util.Collection;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** Words of other renderers for what is called otherwise here: no spelling of theirs is near ours. */
final class Synonyms {
    /** Ours by theirs, in small letters without hyphens; of several the first that is valid where it was written. */
    private static final Map<String, String> OURS = Arrays.stream(
                    """
                    ior indexOfRefraction
                    eta indexOfRefraction
                    aperture lens pupilRadius
                    lensradius lens radius pupilRadius
                    aperturesize lens radius
                    apertureradius lens radius
                    focaldistance lens focusDistance
                    focusdistance lens focusDistance
                    fovaxis fieldOfViewAxis
                    equirectangular panorama
                    spherical panorama
                    environmentcamera panorama
                    thinlens perspective
                    fov fieldOfView
                    angle fieldOfView
                    metal glossy
                    metallic glossy
                    conductor mirror
                    roughconductor glossy
                    dielectric glass
                    roughdielectric glass
                    diffuse matte
                    lambert matte
                    lambertian matte
                    specular mirror
                    albedo color
                    basecolor color
                    reflectance color
                    rgb color
                    emission radiance
                    emissive radiance
                    intensity power
                    position center
                    origin eye
                    from eye
                    target lookAt
                    at lookAt
                    quad rectangle
                    plane rectangle
                    ball sphere
                    spp --samples samples
                    samples --samples antialias
                    resolution --size image
                    width --size
                    height --size
                    out --output
                    integrator --method method
                    depth maxBounces
                    maxdepth maxBounces
                    bounces maxBounces
                    envmap background
                    sky background
                    environment background
                    info inspect
                    check validate
                    lint validate
                    diff compare
                    import convert
                    """
                            .strip()
                            .split("\n"))
            .map(line -> line.strip().split(" ", 2))
            .collect(Collectors.toUnmodifiableMap(words -> words[0], words -> words[1]));

    private Synonyms() {}

    /** The valid word that says what was written; null if none is known. */
    static String of(String written, Collection<String> valid) {
        String plain = written.replaceFirst("^--?", "").replace("-", "").toLowerCase(Locale.ROOT);
        for (String ours : OURS.getOrDefault(plain, "").split(" ")) {
            if (valid.contains(ours) && !ours.equals(written)) {
                return ours;
            }
        }
        return null;
    }
}
