package starlogo.handlers
{
    import starlogo.agents.Breeds;

    /**
     * Returns what a handler has thrown as an error, and adds the handler's breeds to its text. In an error that is thrown again they take the place of
     * those that were added before.
     *
     * @private
     */
    public function nameBreeds(thrown:*, handler:CollisionHandler):Error
    {
        var addition:String = " (in the handler for \"" + Breeds.NAMES.nameOf(handler.colliderBreed) + "\" and \""
            + Breeds.NAMES.nameOf(handler.collideeBreed) + "\")";
        var error:Error = null;
        try
        {
            error = thrown is Error ? thrown : new Error(String(thrown));
            error.message = error.message.replace(/ \(in the handler for "[\s\S]*" and "[\s\S]*"\)$/, "") + addition;
        }
        catch (problem:*)
        {
            // an object may have no text, and in JavaScript an error's text may be read-only
        }
        return error || new Error("an object without a text" + addition);
    }
}
