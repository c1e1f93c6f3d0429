package starlogo.models.cooked
{
    import starlogo.geometry.Fingerprint;

    /**
     * The fingerprint of the arguments of a load. A cooked file is valid only for the arguments for which it was made.
     *
     * @param upAxis "x", "y", "z" or a ModelTransform
     * @param scaling as for Model's constructor
     * @param usesTransforms whether the transform file beside the model's file is fetched too
     *
     * @private
     */
    public function argumentsFingerprint(upAxis:Object, scaling:String, usesTransforms:Boolean):Fingerprint
    {
        // join() calls the transform's toString(). So a program that never uses a ModelTransform need not contain that class.
        return Fingerprint.of([upAxis, scaling, upAxis is String && usesTransforms].join());
    }
}
