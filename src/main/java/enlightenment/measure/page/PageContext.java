package enlightenment.measure.page;

import enlightenment.measure.Need;
import enlightenment.measure.TradeSettings;
import enlightenment.measure.Verdict;

/**
 * What the page tells that the measurements do not know.
 *
 * @param title the scene's name
 * @param renderCommand the command line of the advice as far as it does not depend on it: program, scene, target, options
 * @param compareCommand the command line that checks the picture against the reference
 * @param tradeCommand the command line that made the page
 */
public record PageContext(String title, String renderCommand, String compareCommand, String tradeCommand) {
    private static final String LIGHT_POINTS = " --shadow-samples ";

    /** The whole command line of an advice; its own number of light points goes before the one that was given. */
    public String render(Need advice, TradeSettings settings) {
        String options = " " + Verdict.arguments(advice, settings);
        String command =
                options.contains(LIGHT_POINTS) ? renderCommand.replaceFirst(LIGHT_POINTS + "\\S+", "") : renderCommand;
        return command + options;
    }
}
