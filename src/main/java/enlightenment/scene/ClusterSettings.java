package enlightenment.scene;

import enlightenment.sampling.Distribution;

/**
 * The settings of {@link Method#CLUSTER}.
 *
 * @param proposal the family of distributions that ray clusters propose light points from: {@code "normal"}, {@code "zeta"} or
 *     {@code "linear"}
 */
public record ClusterSettings(String proposal) implements MethodSettings {
    /** {@link #proposal}, {@code "normal"} unless chosen. */
    public static final MethodSetting.Word PROPOSAL = new MethodSetting.Word(
            "proposal", Distribution.NAMES, "distribution that ray clusters propose light samples from");

    /**
     * Checks the name.
     *
     * @throws enlightenment.math.InvalidValueException (key {@code proposal}) if there is no such family
     */
    public ClusterSettings {
        PROPOSAL.checked(proposal);
    }

    /** What was chosen. */
    public static ClusterSettings of(RenderSettings settings) {
        return new ClusterSettings(settings.chosen().word(PROPOSAL));
    }

    @Override
    public Method method() {
        return Method.CLUSTER;
    }

    @Override
    public Object value(MethodSetting setting) {
        return proposal;
    }
}
