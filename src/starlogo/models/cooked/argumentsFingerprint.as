package starlogo.models.cooked
{
    import starlogo.geometry.Fingerprint;

    /**
     * The fingerprint of the arguments that decide what a model's file becomes: a cooked file is for some of them.
     *
     * @param upAxis "x", "y", "z" or a ModelTransform
     * @param scaling as Model's constructor has it
     * @param usesTransforms whether a transform file beside the model's is asked for
     *
     * @private
     */
    public function argumentsFingerprint(upAxis:Object, scaling:String, usesTransforms:Boolean):Fingerprint
    {
        // join() takes the text of a transform, so that what never loads one need not have the class
        var fingerprint:Fingerprint = new Fingerprint();
        fingerprint.addText([upAxis, scaling, upAxis is String && usesTransforms].join());
        return fingerprint;
    }
}
