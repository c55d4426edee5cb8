package enlightenment.plan;

import enlightenment.method.SplatIntegrator;
import enlightenment.sampling.Hash;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.work.Workers;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;
import java.util.stream.Stream;

/**
 * Chooses the method of a render: each that can render the scene makes small pictures of all of it, and the one with the least product
 * of error and cost is taken. Costs are counted, never timed, and random numbers are not the picture's: what is chosen is a function of
 * scene, size, seed and budget, and the same for every crop.
 */
public final class MethodPilot {
    /** Keeps the pilot's random numbers apart from the picture's. */
    private static final long PURPOSE = 0x70696c6f74L;

    /** Pictures of each method, with different seeds: their differences tell the error. */
    private static final int PICTURES = 2;

    /** Camera samples per pixel of a small picture: enough that they are well distributed. */
    private static final int SAMPLES = 4;

    /** Camera samples per pixel in blocks of the render: as many as {@code cluster} shares at least. */
    private static final int SAMPLES_IN_BLOCKS = 8;

    /** Camera samples for each method, as a share of those of the render. */
    private static final double SHARE = 1.0 / 256;

    private static final int FEWEST_SAMPLES = 1 << 12;
    private static final int MOST_SAMPLES = 1 << 15;

    /** Camera samples of a render from which on the pilot pays: it takes one to three seconds at least, most of it to compile what is not used later. */
    private static final double FEWEST_WORTH_A_PILOT = 1 << 20;

    /** {@link #FEWEST_WORTH_A_PILOT} in seconds of a budget. */
    private static final double FEWEST_SECONDS_WORTH_A_PILOT = 60;

    /** Samples per pixel of a render whose budget does not say. */
    private static final double USUAL_SAMPLES = 64;

    /** Blocks that the survey of {@code cluster} looks at, and paths of each of their pixels: about. */
    private static final double SURVEYED_BLOCKS = 24;

    private static final double SURVEY_PATHS = 12;

    /** Smaller factors are reported as none, and larger ones not exactly. */
    private static final double WORTH_TELLING = 1.05;

    private static final double MOST_TOLD = 100;

    /** Methods whose pixels learn from their neighbours, so that blocks of the render's own size are tried. */
    private static final List<BuiltInMethod> OF_BLOCKS =
            List.of(BuiltInMethod.CLUSTER, BuiltInMethod.BIDIRECTIONAL_CLUSTER);

    private static final String ONLY = "no other method renders all of this scene";

    private final CompiledScene scene;

    /** Those of the render, of the whole picture. */
    private final RenderSettings settings;

    /** Settings of the small pictures: those of the render with another size. */
    private final RenderSettings small;

    /** Samples per pixel that are expected of the render. */
    private final double expected;

    private final boolean isWorthIt;
    private final BooleanSupplier cancelled;
    private final List<BuiltInMethod> methods;

    private MethodPilot(Scene description, CompiledScene scene, RenderSettings settings, BooleanSupplier cancelled) {
        this.scene = scene;
        this.cancelled = cancelled;
        expected = samples(settings);
        methods = candidates(description, scene, expected);
        double wanted = SHARE * expected * settings.width() * settings.height();
        double pixels = Math.min(Math.max(wanted, FEWEST_SAMPLES), MOST_SAMPLES) / (PICTURES * SAMPLES);
        double unit = Math.sqrt(pixels / ((double) settings.width() * settings.height()));
        isWorthIt = isWorthPilot(settings.budget(), expected * settings.width() * settings.height());
        this.settings = settings.toBuilder()
                .wholePicture()
                .budget(RenderSettings.Budget.NONE)
                .build();
        small = this.settings.withSize(side(settings.width() * unit), side(settings.height() * unit));
    }

    private static int side(double pixels) {
        return (int) Math.max(Math.rint(pixels), 1);
    }

    private static double samples(RenderSettings settings) {
        RenderSettings.Budget budget = settings.budget();
        if (budget.samples().isPresent()) {
            return budget.samples().getAsDouble();
        }
        return budget.isNone() ? (double) settings.antialias() * settings.antialias() : USUAL_SAMPLES;
    }

    /** Those that can render the scene, see all of it, and have enough samples. */
    private static List<BuiltInMethod> candidates(Scene description, CompiledScene scene, double samples) {
        List<BuiltInMethod> able = new ArrayList<>();
        for (BuiltInMethod method :
                BuiltInMethod.rendering(description.shading().model())) {
            boolean isAble = Method.supports(method, description)
                    && Integrators.blindSpot(method, scene).isEmpty()
                    && Integrators.fewestSamples(method, description.shading().model()) <= samples;
            // Chains pay only for light so rare that no small picture shows it.
            if (isAble && method != BuiltInMethod.METROPOLIS && Integrators.differs(method, scene)) {
                able.add(method);
            }
        }
        return able;
    }

    /**
     * Chooses a method.
     *
     * @param description of the scene
     * @param scene compiled for the size of the settings
     * @param settings of the render; their method is not asked
     * @throws CancellationException if it is cancelled
     */
    public static MethodDecision decide(
            Scene description, CompiledScene scene, RenderSettings settings, BooleanSupplier cancelled) {
        if (scene.physical == null) {
            return classic(description);
        }
        MethodPilot pilot = new MethodPilot(description, scene, settings, cancelled);
        if (pilot.methods.size() == 1) {
            return MethodDecision.of(pilot.methods.get(0), ONLY);
        }
        return pilot.isWorthIt ? pilot.decide() : usual(pilot.methods);
    }

    private static boolean isWorthPilot(RenderSettings.Budget budget, double samples) {
        return samples >= FEWEST_WORTH_A_PILOT
                && budget.seconds().orElse(FEWEST_SECONDS_WORTH_A_PILOT) >= FEWEST_SECONDS_WORTH_A_PILOT;
    }

    /** Of the methods that are best most often the first that is able. */
    private static MethodDecision usual(List<BuiltInMethod> able) {
        BuiltInMethod method = Stream.of(BuiltInMethod.CLUSTER, BuiltInMethod.RAYTRACE)
                .filter(able::contains)
                .findFirst()
                .orElse(able.get(0));
        return MethodDecision.of(method, "it is best most often, and the render is too small for a pilot");
    }

    private static MethodDecision classic(Scene description) {
        return Method.supports(BuiltInMethod.CLUSTER, description)
                ? MethodDecision.of(BuiltInMethod.CLUSTER, "its survey finds where classic shading needs samples")
                : MethodDecision.of(BuiltInMethod.RAYTRACE, ONLY);
    }

    private MethodDecision decide() {
        List<BuiltInMethod> whole = new ArrayList<>(methods);
        whole.remove(BuiltInMethod.CLUSTER);
        Map<BuiltInMethod, List<PilotPicture>> pictures = pictures(whole);
        PilotScores all =
                new PilotScores(small.width(), small.height(), SAMPLES, pictures, BuiltInMethod.BIDIRECTIONAL);
        List<PilotScore> scores = new ArrayList<>();
        for (BuiltInMethod method : whole) {
            if (!OF_BLOCKS.contains(method)) {
                scores.add(all.of(method));
            }
        }
        scores.addAll(ofBlocks(all, whole));
        if (cancelled.getAsBoolean()) {
            throw new CancellationException("stopped before a method was chosen");
        }
        return choose(scores);
    }

    /** By method, small pictures of the whole scene. */
    private Map<BuiltInMethod, List<PilotPicture>> pictures(List<BuiltInMethod> of) {
        PilotPicture[] made = new PilotPicture[of.size() * PICTURES];
        List<RenderPlan> plans = of.stream().map(this::plan).toList();
        double[] contributions = plans.stream().mapToDouble(this::contribution).toArray();
        Workers.run(settings.threads(), made.length, cancelled, () -> (IntConsumer) i -> {
            RenderPlan plan = plans.get(i / PICTURES);
            RenderSettings mine =
                    small.withMethod(plan.method()).withSeed(Hash.of(settings.seed(), PURPOSE, i % PICTURES));
            made[i] = PilotPicture.whole(plan, scene, mine, contributions[i / PICTURES], cancelled);
        });
        if (cancelled.getAsBoolean()) {
            throw new CancellationException("stopped before a method was chosen");
        }
        Map<BuiltInMethod, List<PilotPicture>> byMethod = new EnumMap<>(BuiltInMethod.class);
        for (int m = 0; m < of.size(); m++) {
            byMethod.put(of.get(m), Arrays.asList(made).subList(m * PICTURES, (m + 1) * PICTURES));
        }
        return byMethod;
    }

    /** The scores of methods whose pixels learn from their neighbours, relative to that of the method whose paths they share. */
    private List<PilotScore> ofBlocks(PilotScores all, List<BuiltInMethod> whole) {
        List<BuiltInMethod> able = new ArrayList<>(OF_BLOCKS);
        able.retainAll(methods);
        List<PilotScore> scores = new ArrayList<>();
        if (able.isEmpty()) {
            return scores;
        }
        List<BuiltInMethod> compared = new ArrayList<>(able);
        compared.add(BuiltInMethod.RAYTRACE);
        double pixels = small.width() * small.height() / 2.0;
        PilotBlocks blocks = new PilotBlocks(scene, settings, SAMPLES_IN_BLOCKS, pixels);
        blocks.render(compared, PURPOSE, PICTURES, cancelled);
        PilotScore ray = all.of(BuiltInMethod.RAYTRACE);
        double share = all.shareOfTiles(BuiltInMethod.RAYTRACE);
        double surveyed =
                Math.min(SURVEYED_BLOCKS * blocks.pixelsOfBlock() / ((double) settings.width() * settings.height()), 1);
        double survey = 1 + surveyed * SURVEY_PATHS / expected;
        for (BuiltInMethod method : able) {
            double cost = ray.cost() * blocks.cost(method) / blocks.cost(BuiltInMethod.RAYTRACE) * survey;
            PilotScore relative = relative(method, ray, share, blocks, cost);
            scores.add(whole.contains(method) ? better(relative, all.of(method)) : relative);
        }
        return scores;
    }

    /**
     * The score with the smaller of two estimates of variance: in small pictures pixels are too far apart to share much, and a ratio to a
     * method of large variance is hardly known. Light that was missed in the small pictures counts.
     */
    private static PilotScore better(PilotScore relative, PilotScore small) {
        PilotScore least = relative.variance() < small.variance() ? relative : small;
        return new PilotScore(small.method(), least.variance(), least.uncertain(), small.missed(), relative.cost());
    }

    /** It misses what the method misses whose paths it shares, in proportion. */
    private static PilotScore relative(
            BuiltInMethod method, PilotScore ray, double share, PilotBlocks blocks, double cost) {
        double ofRay = blocks.variance(BuiltInMethod.RAYTRACE);
        double factor = 1 - share + (ofRay > 0 ? share * blocks.variance(method) / ofRay : share);
        return new PilotScore(method, ray.variance() * factor, ray.uncertain() * factor, ray.missed(), cost);
    }

    private RenderPlan plan(BuiltInMethod method) {
        if (method == BuiltInMethod.BIDIRECTIONAL_CLUSTER) {
            RenderPlan ray = plan(BuiltInMethod.RAYTRACE);
            return new RenderPlan(method, PilotBlocks.NO_EFFORT, 2 * SAMPLES, "pilot", ray.lightPaths());
        }
        return new SamplePlans(scene, small.withMethod(method), cancelled).of(SAMPLES, "pilot");
    }

    private double contribution(RenderPlan plan) {
        if (plan.lightPaths() == 0) {
            return 0;
        }
        RayCounters unread = new RayCounters(scene.kindNames.size());
        SplatIntegrator paths = Integrators.splats(plan, scene, small, unread);
        return paths.expectedContribution();
    }

    private static MethodDecision choose(List<PilotScore> scores) {
        List<PilotScore> sorted = new ArrayList<>(scores);
        // Where nothing varies the cheapest is best.
        sorted.sort(Comparator.comparingDouble(PilotScore::work).thenComparingDouble(PilotScore::cost));
        PilotScore best = sorted.get(0);
        PilotScore next = sorted.get(1);
        double factor = next.work() / best.work();
        String than = factor >= WORTH_TELLING
                ? String.format(Locale.ROOT, "%s times less squared error for its cost than ", told(factor))
                : "no more squared error for its cost than ";
        return MethodDecision.of(
                best.method(),
                "in small pilot pictures it had " + than + next.method().word());
    }

    /** Two digits; a pilot tells no more. */
    private static String told(double factor) {
        return factor < MOST_TOLD
                ? String.format(Locale.ROOT, factor < 10 ? "%.1f" : "%.0f", factor)
                : "over a hundred";
    }
}
