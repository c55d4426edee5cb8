package enlightenment.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * No constant in the code that decides pixels knows a scale: every floating-point literal other than 0, 1/2, 1 and 2 is
 * listed here with the reason why it is none. (Bit-identity under scaling, {@code ImageInvarianceTest}, finds what is not
 * written as a literal.)
 */
class FloatingLiteralsTest {
    private static final List<String> PACKAGES = List.of(
            "numeric",
            "math",
            "frame",
            "primitive",
            "geometry",
            "bvh",
            "accel",
            "mesh",
            "world",
            "film",
            "transport",
            "classic",
            "probe",
            "method",
            "sampling",
            "bsdf",
            "emitter",
            "camera");

    /** Literals that say nothing about a scale. */
    private static final Set<Double> FREE = Set.of(0.0, 0.5, 1.0, 2.0);

    /**
     * A literal that is no scale.
     *
     * @param file below src/main/java/enlightenment
     * @param literal as it is written
     * @param why what it stands for
     */
    private record Explained(String file, String literal, String why) {}

    private static final String ARC = "a coefficient of the polynomial that stands for θ/sin θ as a function of cos θ";

    private static final List<Explained> EXPLAINED = List.of(
            new Explained("geometry/Mesh.java", "1.01", "the middle of the box is rounded to a thousandth of its size"),
            new Explained("mesh/tree/Departure.java", "4", "how many times its own rounding a corner is away"),
            new Explained("mesh/tree/ShaftTriangles.java", "64", "ratio: how slender a triangle may be"),
            new Explained(
                    "mesh/tree/TriangleTest.java",
                    "4",
                    "how many times its own rounding an edge function is away from 0"),
            new Explained("primitive/UnionMembers.java", "0x1p10", "how many times its size a mesh is away: a ratio"),
            new Explained(
                    "numeric/Decimals.java",
                    "0x1p40",
                    "digits of a number, where the rounding of a product begins to count"),
            new Explained("numeric/Scale.java", "0x1p-53", "unit roundoff of doubles: the format itself"),
            new Explained(
                    "numeric/Angles.java", "0.198912367379658", "tan(π/16): where a reduction of the angle changes"),
            new Explained("numeric/Angles.java", "0.41421356237309503", "tan(π/8): what the reduction subtracts"),
            new Explained("numeric/Angles.java", "0.6681786379192989", "tan(3π/16): where the reduction changes"),
            new Explained("numeric/Arcs.java", "6.123233995736766e-17", "π/2 less its nearest double"),
            new Explained("numeric/Arcs.java", "0.13333333333334924", ARC),
            new Explained("numeric/Arcs.java", "0.05714285714079507", ARC),
            new Explained("numeric/Arcs.java", "0.02539682550179677", ARC),
            new Explained("numeric/Arcs.java", "0.011544008764042558", ARC),
            new Explained("numeric/Arcs.java", "0.00532804927222027", ARC),
            new Explained("numeric/Arcs.java", "0.002485954425869126", ARC),
            new Explained("numeric/Arcs.java", "0.0011731553423059266", ARC),
            new Explained("numeric/Arcs.java", "0.000539566898913318", ARC),
            new Explained("numeric/Arcs.java", "0.0003126151535212897", ARC),
            new Explained("numeric/Arcs.java", "1.4743017805349805e-05", ARC),
            new Explained("numeric/Arcs.java", "0.00023105799880840196", ARC),
            new Explained("numeric/Arcs.java", "0.000132157752596636", ARC),
            new Explained("numeric/Arcs.java", "9.195087903114487e-05", ARC),
            new Explained("emitter/ParallelogramLight.java", "1.25", "a ratio of squared distances"),
            new Explained("world/light/PhysicalLight.java", "0.2126", "luminance of red (Rec. 709), a ratio"),
            new Explained("world/light/PhysicalLight.java", "0.7152", "luminance of green"),
            new Explained("world/light/PhysicalLight.java", "0.0722", "luminance of blue"),
            new Explained("world/material/AlbedoInversion.java", "0.125", "an angle"),
            new Explained("world/camera/AffineProjection.java", "0x1p-300", "range of doubles: another unit below it"),
            new Explained(
                    "world/material/AlbedoInversion.java", "0x1p-10", "a ratio of albedos: where a series begins"),
            new Explained("world/material/AlbedoInversion.java", "0.25", "a term of the series of the logarithm"),
            new Explained("world/material/AlbedoInversion.java", "0.2", "a term of the series of the logarithm"),
            new Explained("sampling/SobolSampler.java", "0x1p-32", "32 bits to 0..1"),
            new Explained("bsdf/Microfacets.java", "0.0625", "a roughness α of GGX"),
            new Explained("world/light/SmallLights.java", "0.1", "steradians"),
            new Explained("world/light/CausticPass.java", "0.05", "the least cosine that powers are estimated with"),
            new Explained("world/check/RefractingMedia.java", "1e-3", "a share of a hemisphere"),
            new Explained(
                    "transport/image/MirrorImage.java", "0x1p-3", "Newton's method: an error over the radius, a ratio"),
            new Explained(
                    "transport/image/MirrorImage.java", "0x1p-6", "an image is so much wider than it need be: a ratio"),
            new Explained(
                    "transport/image/EyeImages.java", "0x1p-20", "pixels: what samples near the next one may show"),
            new Explained("world/light/LightOutline.java", "0x1p-9", "pixels: how fine a polygon in the picture is"),
            new Explained(
                    "world/light/LightOutline.java", "0x1p30", "pixels: where a double tells no thousandth of one"),
            new Explained("transport/bidirectional/PathSampler.java", "0x1p-32", "32 bits to 0..1"),
            new Explained(
                    "transport/state/PathValue.java", "0.05", "roulette: a share of a path's throughput, a ratio"),
            new Explained("transport/state/PathValue.java", "0.99", "roulette: the largest probability to survive"),
            new Explained(
                    "transport/direct/FlightLamps.java",
                    "6",
                    "the mean length of flights over distances that are near"),
            new Explained("transport/media/FreeFlight.java", "0.1", "the least probability of a band of a flight"),
            new Explained(
                    "transport/state/RussianRoulette.java",
                    "4",
                    "units of the frame, in which every coordinate is below 2"),
            new Explained(
                    "transport/media/FreeFlight.java", "0x1p100", "units of the frame: nothing comes back from there"),
            new Explained("transport/bidirectional/MediumVertex.java", "0x1p-8", "roulette: a share of all events"),
            new Explained(
                    "world/material/HomogeneousMedium.java",
                    "0x1p36",
                    "mean free paths in the frame, in which every coordinate is below 2 and rounded to 2^-52"),
            new Explained(
                    "transport/bidirectional/SubpathDensities.java",
                    "0x1p-500",
                    "a cosine that can be squared: no quotient of 0"),
            new Explained("numeric/Scale.java", "0x1p100", "brings a subnormal number into the normal range, exactly"),
            new Explained(
                    "primitive/SpherePrimitive.java", "0.75", "ratio of two roots that chooses between equal forms"),
            new Explained(
                    "bvh/BvhBuilder.java",
                    "0x1p-14",
                    "relative: below it floats would blur a leaf, so doubles are taken; the answers are the same"),
            new Explained(
                    "bvh/FloatSlabs.java",
                    "0x1p-19",
                    "relative: more than the roundings of floats, which have 24 bits"),
            new Explained("bvh/FloatSlabs.java", "0x1p-40", "range of floats: beyond it doubles are taken"),
            new Explained("bvh/FloatSlabs.java", "0x1p40", "range of floats: beyond it doubles are taken"),
            new Explained("bvh/FloatSlabs.java", "0x1p60", "range of floats: an inverse that does not overflow"),
            new Explained(
                    "bvh/FloatShaft.java",
                    "0x1p-19",
                    "relative: more than the roundings of floats, which have 24 bits"),
            new Explained(
                    "bvh/FloatShaft.java",
                    "0x1p-20f",
                    "relative: more than the roundings of floats, which have 24 bits"),
            new Explained("bvh/FloatShaft.java", "0x1p-12f", "share of a segment: more than the roundings of floats"),
            new Explained("bvh/FloatShaft.java", "0x1p60f", "range of floats: stands for no limit"),
            new Explained("accel/ApexBalls.java", "0x1p-40", "relative: more than the roundings of doubles"),
            new Explained("accel/ApexBalls.java", "0x1p480", "range of doubles: beyond it nothing is left out"),
            new Explained("accel/ApexBalls.java", "0x1p-480", "range of doubles: beyond it nothing is left out"),
            new Explained(
                    "mesh/TriangleMesh.java", "1e30", "range of squares: a transform makes meshes larger or smaller"),
            new Explained("primitive/MeshPrimitive.java", "0.2911", "a direction, of which the length does not count"),
            new Explained("primitive/MeshPrimitive.java", "0.5773", "a direction, of which the length does not count"),
            new Explained("primitive/MeshPrimitive.java", "0.7631", "a direction, of which the length does not count"),
            new Explained("primitive/Ray.java", "0x1p240", "where squares could overflow: chooses the rescaling path"),
            new Explained(
                    "primitive/Ray.java", "0x1p-240", "where squares could underflow: chooses the rescaling path"),
            new Explained(
                    "frame/Parallelograms.java",
                    "0x1p-26",
                    "validation limit, relative to the rectangle's own longer edge"),
            new Explained(
                    "world/camera/AffineCamera.java",
                    "-16",
                    "units of the frame, in which every coordinate is below 2"),
            new Explained(
                    "numeric/Decimals.java", "3.3219280948873626", "the binary logarithm of ten, for an estimate"),
            new Explained(
                    "math/ExactPoint.java", "0x1p-40", "relative: when a sum of roundings asks for exact arithmetic"),
            new Explained(
                    "primitive/EndFaces.java", "4", "tolerances: how far to look for a face that is known to coincide"),
            new Explained("bsdf/RoughDiffuse.java", "0.0012624911", "arc cosine: Abramowitz and Stegun 4.4.46"),
            new Explained("bsdf/RoughDiffuse.java", "0.0066700901", "arc cosine: Abramowitz and Stegun 4.4.46"),
            new Explained("bsdf/RoughDiffuse.java", "0.0170881256", "arc cosine: Abramowitz and Stegun 4.4.46"),
            new Explained("bsdf/RoughDiffuse.java", "0.0308918810", "arc cosine: Abramowitz and Stegun 4.4.46"),
            new Explained("bsdf/RoughDiffuse.java", "0.0501743046", "arc cosine: Abramowitz and Stegun 4.4.46"),
            new Explained("bsdf/RoughDiffuse.java", "0.0889789874", "arc cosine: Abramowitz and Stegun 4.4.46"),
            new Explained("bsdf/RoughDiffuse.java", "0.2145988016", "arc cosine: Abramowitz and Stegun 4.4.46"),
            new Explained("bsdf/RoughDiffuse.java", "1.5707963050", "arc cosine: Abramowitz and Stegun 4.4.46"),
            new Explained("bsdf/RoughDiffuse.java", "3.0", "two thirds, in the model's closed form"),
            new Explained("bsdf/Fresnel.java", "0x1p100", "an index of refraction: a ratio of speeds"),
            new Explained("bsdf/GlossyReflection.java", "0.1", "a share of samples"),
            new Explained(
                    "bsdf/LostAtInterface.java", "0.75", "a share of light, measured by random walks among facets"),
            new Explained("bsdf/RoughDielectric.java", "0.1", "a share of samples"),
            new Explained("bsdf/Microfacets.java", "1e-4", "a roughness: a ratio of slopes"),
            new Explained("sampling/Hash.java", "0x1p-53", "maps 53 random bits to [0, 1)"),
            new Explained("sampling/Sobol.java", "0x1p-32", "maps 32 bits of a sequence to [0, 1)"),
            new Explained("numeric/Arcs.java", "6.0", "3!, sine series"),
            new Explained("numeric/Arcs.java", "24.0", "4!, cosine series"),
            new Explained("numeric/Arcs.java", "120.0", "5!, sine series"),
            new Explained("numeric/Arcs.java", "720.0", "6!, cosine series"),
            new Explained("numeric/Arcs.java", "5040.0", "7!, sine series"),
            new Explained("numeric/Arcs.java", "40320.0", "8!, cosine series"),
            new Explained("numeric/Arcs.java", "362880.0", "9!, sine series"),
            new Explained("numeric/Arcs.java", "3628800.0", "10!, cosine series"),
            new Explained("numeric/Arcs.java", "39916800.0", "11!, sine series"),
            new Explained("numeric/Arcs.java", "479001600.0", "12!, cosine series"),
            new Explained("numeric/Arcs.java", "6227020800.0", "13!, sine series"),
            new Explained("numeric/Arcs.java", "87178291200.0", "14!, cosine series"),
            new Explained("numeric/Arcs.java", "1307674368000.0", "15!, sine series"),
            new Explained("numeric/Arcs.java", "20922789888000.0", "16!, cosine series"),
            new Explained("numeric/Arcs.java", "355687428096000.0", "17!, sine series"),
            new Explained("numeric/Arcs.java", "6402373705728000.0", "18!, cosine series"),
            new Explained("numeric/Exponential.java", "0.6931471805599453", "ln 2"),
            new Explained("numeric/Exponential.java", "1.4426950408889634", "1/ln 2"),
            new Explained("numeric/Exponential.java", "2.3190468138462996e-17", "what the rounding of ln 2 left off"),
            new Explained("sampling/Truncated.java", "0x1p-6", "steepness times width: a relative change of density"),
            new Explained("sampling/Proposal.java", "0x1p-54", "half of the last bit of a 53-bit number"),
            new Explained("sampling/Proposal.java", "0x1p-53", "the last bit of a 53-bit number"),
            new Explained("sampling/Proposal.java", "0x1p500", "deviations, beyond which squares could overflow"),
            new Explained("sampling/TruncatedNormal.java", "0x1p-30", "relative: where a quadratic iteration stops"),
            new Explained("sampling/ZetaSum.java", "0x1p-30", "relative: where a quadratic iteration stops"),
            new Explained("sampling/NormalIntegral.java", "0.46875", "Cody: where the first approximation ends"),
            new Explained("sampling/NormalIntegral.java", "0.425", "Wichura: where the first approximation ends"),
            new Explained("sampling/NormalIntegral.java", "0.180625", "0.425², a probability squared"),
            new Explained("sampling/NormalIntegral.java", "1.6", "Wichura: centre of the second approximation"),
            new Explained(
                    "emitter/HorizonPolygon.java",
                    "0x1p-9",
                    "ratio of size to distance that chooses between equal forms"),
            new Explained("emitter/HorizonPolygon.java", "9.0", "9/40: weight of a quadrature"),
            new Explained(
                    "emitter/LightWeights.java", "0.25", "Cauchy: the mean share of its area that a convex body shows"),
            new Explained(
                    "emitter/LightWeights.java", "0x1p-900", "range of doubles: an inverse that does not overflow"),
            new Explained(
                    "emitter/LightWeights.java", "4", "ratio of distance to size that chooses between two weights"),
            new Explained("emitter/LightWeights.java", "0x1p-10", "share of a weight whose sign is certain"),
            new Explained(
                    "emitter/PictureProfile.java", "0.125", "share of a neighbour's brightness in a cell's weight"),
            new Explained("emitter/PictureProfile.java", "0.2126", "luminance"),
            new Explained("emitter/PictureProfile.java", "0.7152", "luminance"),
            new Explained("emitter/PictureProfile.java", "0.0722", "luminance"),
            new Explained("emitter/NormalCone.java", "0x1p-24", "angle: more than what the arc cosine is off by"),
            new Explained(
                    "emitter/ParallelogramLight.java", "1e-3", "solid angle that chooses between two ways of sampling"),
            new Explained(
                    "emitter/ParallelogramLight.java", "1e-9", "solid angle that chooses between two ways of sampling"),
            new Explained("emitter/SphericalRectangle.java", "0x1p-6", "cosine that chooses between two equal forms"),
            new Explained("emitter/SphereIrradiance.java", "0.25", "tangent that chooses between equal forms"),
            new Explained("emitter/SphereIrradiance.java", "4.0", "coefficients of a series"),
            new Explained("emitter/SphereIrradiance.java", "7.0", "coefficients of a series"),
            new Explained("film/ErrorEstimate.java", "1.96", "deviations that hold 95 % of a normal distribution"),
            new Explained(
                    "film/ErrorEstimate.java",
                    "1.23",
                    "ln 40/3: three pixels of which no sample meets so much in one of 40 pictures"),
            new Explained("film/Neighbours.java", "16.0", "4²: the density of two points of one pixel"),
            new Explained("film/LightInterval.java", "8", "ratio of variances"),
            new Explained("film/LinearError.java", "100", "kurtosis, a ratio"),
            new Explained("film/LinearFigures.java", "0.05", "share of the mean, by the definition of the error"),
            new Explained("film/LinearFigures.java", "3.0", "number of bands"),
            new Explained("film/PathDecay.java", "0.3", "share or ratio of variances"),
            new Explained("film/PathDecay.java", "0.6", "share or ratio of variances, fitted"),
            new Explained("film/PathDecay.java", "0.7", "power of a share, fitted"),
            new Explained("film/PathDecay.java", "1.15", "share or ratio of variances, fitted"),
            new Explained("film/PathDecay.java", "1.4", "power of a share, fitted"),
            new Explained("film/PathDecay.java", "2.5", "share or ratio of variances, fitted"),
            new Explained("film/PathDecay.java", "4", "share or ratio of variances"),
            new Explained("film/VarianceDecay.java", "2.3", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "2.6", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "3.5", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "4.2", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.45", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.43", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.42", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.41", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.35", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.3", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.2", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.17", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.12", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.98", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.71", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.57", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.51", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.46", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.37", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.23", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.19", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.14", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "1.08", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.95", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.76", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.64", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.49", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.36", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.28", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.33", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.38", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.34", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.48", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.22", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.18", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.85", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "1.15", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.4", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.7", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "1.25", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.8", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.6", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "0.65", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "1.3", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "1.6", "share or ratio of variances, fitted"),
            new Explained("film/VarianceDecay.java", "1.8", "share or ratio of variances, fitted"),
            new Explained("method/Dither.java", "1.32471795724474602596", "the root of g³ = g + 1"),
            new Explained("method/metropolis/BlockChains.java", "0.2", "paths that a step is worth, measured"),
            new Explained("method/metropolis/Paths.java", "0.2126", "luminance of red"),
            new Explained("method/metropolis/Paths.java", "0.7152", "luminance of green"),
            new Explained("method/metropolis/Paths.java", "0.0722", "luminance of blue"),
            new Explained("method/metropolis/Spending.java", "0.25", "share of the samples"),
            new Explained("classic/cluster/Allocation.java", "2.85", "exponent: how fast variances fall with samples"),
            new Explained("classic/cluster/Allocation.java", "2.5", "exponent: how fast variances fall with samples"),
            new Explained("classic/cluster/Allocation.java", "3", "light points that are worth a ray"),
            new Explained("classic/cluster/Allocation.java", "0.25", "share of the samples"),
            new Explained("classic/cluster/Allocation.java", "0.125", "share of a step of binary logarithms"),
            new Explained("method/cluster/PhysicalClusterCost.java", "0.25", "share of the samples"),
            new Explained("classic/cluster/ClusterCost.java", "0.25", "share of the pixels"),
            new Explained("method/cluster/SharingGain.java", "32.0", "ratio of times, measured"),
            new Explained("method/cluster/PathNoise.java", "8", "paths that a block counts as, measured"),
            new Explained(
                    "method/cluster/PhysicalAllocation.java", "1.5", "exponent: how fast variances fall with samples"),
            new Explained("method/cluster/PhysicalAllocation.java", "0.125", "share of a step of binary logarithms"),
            new Explained("method/cluster/PhysicalAllocation.java", "0x1p-27", "variance of colours as shown"),
            new Explained("method/cluster/PhysicalAllocation.java", "1.41421356237309504880", "the root of 2"),
            new Explained("classic/cluster/Evidence.java", "8", "ratio of weights, measured"),
            new Explained("classic/cluster/Evidence.java", "6", "ratio of variances, measured"),
            new Explained("classic/cluster/Evidence.java", "0.3", "share of a variance, measured"),
            new Explained("classic/cluster/ClusterMethod.java", "0.2", "share of light points"),
            new Explained("classic/cluster/Lobe.java", "1.25", "factor on a variance"),
            new Explained(
                    "classic/cluster/SampleDemand.java",
                    "0.003",
                    "ratio of variances of display-referred colours, measured"),
            new Explained(
                    "classic/cluster/SampleDemand.java",
                    "0.3",
                    "ratio of variances of display-referred colours, measured"),
            new Explained(
                    "classic/cluster/SampleDemand.java",
                    "0.1",
                    "ratio of variances of display-referred colours, measured"),
            new Explained("classic/cluster/SampleDemand.java", "0x1p-13", "variance of display-referred colours"),
            new Explained("classic/cluster/SampleDemand.java", "0x1p-27", "variance of display-referred colours"),
            new Explained("classic/cluster/SampleDemand.java", "6", "1 + 4 + 1: variance of a second difference"),
            new Explained("classic/cluster/ClusterProposal.java", "0.125", "share of a mixture"),
            new Explained("classic/cluster/ClusterProposal.java", "0.25", "share of a mixture"),
            new Explained("classic/cluster/ClusterProposal.java", "3", "ratio of variances that pays"));

    /** Coefficients of published approximations in dimensionless variables. */
    private static final Map<String, List<String>> CITED = Map.of(
            "Cody 1969: error function of a number of deviations",
            List.of(
                    "1.85777706184603153E-1",
                    "3.16112374387056560E0",
                    "1.13864154151050156E2",
                    "3.77485237685302021E2",
                    "3.20937758913846947E3",
                    "2.36012909523441209E1",
                    "2.44024637934444173E2",
                    "1.28261652607737228E3",
                    "2.84423683343917062E3",
                    "2.15311535474403846E-8",
                    "5.64188496988670089E-1",
                    "8.88314979438837594E0",
                    "6.61191906371416295E1",
                    "2.98635138197400131E2",
                    "8.81952221241769090E2",
                    "1.71204761263407058E3",
                    "2.05107837782607147E3",
                    "1.23033935479799725E3",
                    "1.57449261107098347E1",
                    "1.17693950891312499E2",
                    "5.37181101862009858E2",
                    "1.62138957456669019E3",
                    "3.29079923573345963E3",
                    "4.36261909014324716E3",
                    "3.43936767414372164E3",
                    "1.23033935480374942E3",
                    "1.63153871373020978E-2",
                    "3.05326634961232344E-1",
                    "3.60344899949804439E-1",
                    "1.25781726111229246E-1",
                    "1.60837851487422766E-2",
                    "6.58749161529837803E-4",
                    "2.56852019228982242E0",
                    "1.87295284992346725E0",
                    "5.27905102951428412E-1",
                    "6.05183413124413191E-2",
                    "2.33520497626869185E-3"),
            "Wichura 1988: quantile of a probability",
            List.of(
                    "2.5090809287301226727E3",
                    "3.3430575583588128105E4",
                    "6.7265770927008700853E4",
                    "4.5921953931549871457E4",
                    "1.3731693765509461125E4",
                    "1.9715909503065514427E3",
                    "1.3314166789178437745E2",
                    "3.3871328727963666080E0",
                    "5.2264952788528545610E3",
                    "2.8729085735721942674E4",
                    "3.9307895800092710610E4",
                    "2.1213794301586595867E4",
                    "5.3941960214247511077E3",
                    "6.8718700749205790830E2",
                    "4.2313330701600911252E1",
                    "7.74545014278341407640E-4",
                    "2.27238449892691845833E-2",
                    "2.41780725177450611770E-1",
                    "1.27045825245236838258E0",
                    "3.64784832476320460504E0",
                    "5.76949722146069140550E0",
                    "4.63033784615654529590E0",
                    "1.42343711074968357734E0",
                    "1.05075007164441684324E-9",
                    "5.47593808499534494600E-4",
                    "1.51986665636164571966E-2",
                    "1.48103976427480074590E-1",
                    "6.89767334985100004550E-1",
                    "1.67638483018380384940E0",
                    "2.05319162663775882187E0",
                    "2.01033439929228813265E-7",
                    "2.71155556874348757815E-5",
                    "1.24266094738807843860E-3",
                    "2.65321895265761230930E-2",
                    "2.96560571828504891230E-1",
                    "1.78482653991729133580E0",
                    "5.46378491116411436990E0",
                    "6.65790464350110377720E0",
                    "2.04426310338993978564E-15",
                    "1.42151175831644588870E-7",
                    "1.84631831751005468180E-5",
                    "7.86869131145613259100E-4",
                    "1.48753612908506148525E-2",
                    "1.36929880922735805310E-1",
                    "5.99832206555887937690E-1"));

    private static List<Explained> explained() {
        List<Explained> all = new ArrayList<>(EXPLAINED);
        CITED.forEach((why, literals) ->
                literals.forEach(l -> all.add(new Explained("sampling/NormalIntegral.java", l, why))));
        IntStream.rangeClosed(1, 22)
                .forEach(e -> all.add(
                        new Explained("mesh/input/TextInput.java", "1e" + e, "decimals of a text: exact powers")));
        return all;
    }

    /** Comments, texts and characters: what is not code. Longer forms first. */
    private static final Pattern NOT_CODE = Pattern.compile(
            "//[^\n]*|/\\*.*?\\*/|\"\"\".*?\"\"\"|\"(?:\\\\.|[^\"\\\\\n])*\"|'(?:\\\\.|[^'\\\\\n])+'", Pattern.DOTALL);

    /** Java's floating-point literals: hexadecimal; with a point; with an exponent; with a suffix. */
    private static final Pattern LITERAL = Pattern.compile("(?<![\\w.])(?:"
            + "0[xX][0-9a-fA-F_]*\\.?[0-9a-fA-F_]*[pP][+-]?[0-9_]+[fFdD]?"
            + "|[0-9][0-9_]*\\.[0-9_]*(?:[eE][+-]?[0-9_]+)?[fFdD]?"
            + "|\\.[0-9][0-9_]*(?:[eE][+-]?[0-9_]+)?[fFdD]?"
            + "|[0-9][0-9_]*[eE][+-]?[0-9_]+[fFdD]?"
            + "|[0-9][0-9_]*[fFdD]"
            + ")(?!\\w)");

    /** A whole number that becomes a double because of where it stands. */
    private static final Pattern WHOLE_AS_DOUBLE =
            Pattern.compile("\\b(?:double|float)\\s+\\w+\\s*=\\s*(-?[0-9_]+)\\s*;");

    private static List<String> literals(String source) {
        String code = NOT_CODE.matcher(source).replaceAll(" ");
        List<String> all = new ArrayList<>();
        for (Matcher m = LITERAL.matcher(code); m.find(); ) {
            all.add(m.group());
        }
        for (Matcher m = WHOLE_AS_DOUBLE.matcher(code); m.find(); ) {
            all.add(m.group(1));
        }
        return all;
    }

    private static boolean isFree(String literal) {
        return FREE.contains(Double.parseDouble(literal.replace("_", "")));
    }

    private static Set<String> found() throws IOException {
        Path root = Path.of(System.getProperty("project.directory"), "src", "main", "java", "enlightenment");
        Set<String> found = new TreeSet<>();
        for (String name : PACKAGES) {
            try (Stream<Path> files = Files.walk(root.resolve(name))) {
                for (Path file :
                        files.filter(f -> f.toString().endsWith(".java")).toList()) {
                    String relative = root.relativize(file).toString().replace('\\', '/');
                    for (String literal : literals(Files.readString(file))) {
                        if (!isFree(literal)) {
                            found.add(relative + ": " + literal);
                        }
                    }
                }
            }
        }
        return found;
    }

    @Test
    void everyFloatingLiteralOfTheGeometryIsExplained() throws IOException {
        Set<String> unexplained = found();
        for (Explained e : explained()) {
            unexplained.remove(e.file + ": " + e.literal);
        }
        assertEquals(Set.of(), unexplained, "say in this test why these know no scale, or remove them");
    }

    @Test
    void everyExplainedLiteralIsStillThere() throws IOException {
        Set<String> listed = new HashSet<>();
        for (Explained e : explained()) {
            listed.add(e.file + ": " + e.literal);
            assertEquals(false, e.why.isBlank());
        }
        listed.removeAll(found());
        assertEquals(Set.of(), listed);
    }

    @Test
    void theScanSeesEveryFormOfLiteralAndNothingElse() {
        String source =
                """
                /** 1e-6 in a comment */ // 2e-7 in another
                String s = "3e-8 \\" 4e-9"; char c = '5'; int i = 42; long l = 0xFFL; int k = a[1].length;
                double a = 1e-3, b = 1.5, d = .25, e = 6., f = 7d, g = 0x1.8p-4, h = 1_000.5e+2, n = 8f;
                double w = 16;
                double v = -12 ;
                """;
        assertEquals(
                List.of("1e-3", "1.5", ".25", "6.", "7d", "0x1.8p-4", "1_000.5e+2", "8f", "16", "-12"),
                literals(source));
    }
}
