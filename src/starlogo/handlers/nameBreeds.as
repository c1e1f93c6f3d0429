package starlogo.handlers
{
    import starlogo.agents.Breeds;

    /**
     * Adds the breeds of a handler to the text of an error that it has thrown. An error that is thrown again keeps one such addition.
     *
     * @return the error
     *
     * @private
     */
    public function nameBreeds(error:Error, handler:CollisionHandler):Error
    {
        var addition:String = " (in the handler for \"" + Breeds.NAMES.nameOf(handler.colliderBreed) + "\" and \""
            + Breeds.NAMES.nameOf(handler.collideeBreed) + "\")";
        try
        {
            if (error.message.slice(-addition.length) != addition)
            {
                error.message += addition;
            }
        }
        catch (problem:*)
        {
            // in JavaScript an error's text may be read-only, or no string
        }
        return error;
    }
}
