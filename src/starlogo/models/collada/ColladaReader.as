package starlogo.models.collada
{
    import flash.geom.Vector3D;
    import starlogo.models.Model;
    import starlogo.models.ModelTransform;
    import starlogo.models.animation.Pose;
    import starlogo.models.building.ModelData;
    import starlogo.models.building.ModelReader;
    import starlogo.models.building.removingUnusedVertices;
    import starlogo.models.files.refuseFileIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Reads a COLLADA document. ColladaModel says which parts.
     *
     * <p>A ColladaDocument has an XmlReader, which makes ColladaElements of the text, and keeps what several poses share. A ColladaScene visits
     * the ColladaNodes, whose transforms come from ColladaTransforms. Each geometry is a ColladaMesh. It has the points of ColladaAccessors, and
     * the triangles of ColladaPrimitives. Each instance of a geometry is a ColladaInstance, which adds the mesh to the model.</p>
     *
     * <p>Before that, it moves the points of a geometry that a controller places. It does so by morphs and by ColladaSkins. A ColladaSkin has the
     * JointInfluences of its points, and finds its joints among the nodes.</p>
     *
     * @private
     */
    public final class ColladaReader extends StepSequence implements ModelReader
    {
        private var _data:ModelData;

        /**
         * @param document the document; its steps may be done
         * @param upAxis "x", "y" or "z"; a ModelTransform leaves the document as it is; null for the axis that the document names
         * @param scaling as for Model's constructor; null if the vertices are not normalised
         * @param pose the pose, whose targets are the elements' indices; null at rest
         */
        public function ColladaReader(document:ColladaDocument, upAxis:Object, scaling:String, pose:Pose = null)
        {
            _data = ModelData.forFile(document.budget.modelName, upAxis, scaling, "y");
            var scene:ColladaScene;
            add(document).begin(function():Steps
                {
                    _data.upAxis = upAxis == null ? document.upAxis : _data.upAxis;
                    _data.transform = scaling == Model.AS_GIVEN && _data.transform == null ? scalingBy(document.unit) : _data.transform;
                    scene = new ColladaScene(document, pose);
                    return scene;
                }).begin(function():Steps
                {
                    return adding(scene.instances);
                }).add(removingUnusedVertices(_data.vertices, _data.triangles));
        }

        /** @inheritDoc */
        public function get data():ModelData
        {
            return _data;
        }

        // The transform that scales by a unit; null for none.
        private static function scalingBy(unit:Number):ModelTransform
        {
            return unit == 1 ? null : new ModelTransform(null, new Vector3D(unit, unit, unit));
        }

        private function adding(instances:Vector.<ColladaInstance>):Steps
        {
            // all geometries come first, so skins only have what these leave of the limits
            return new StepSequence().beginEach(instances.length, function(index:int):Steps
                {
                    _data.readProgress = index / instances.length / 2;
                    return instances[index].mesh;
                }).beginEach(instances.length, function(index:int):Steps
                {
                    _data.readProgress = (1 + index / instances.length) / 2;
                    return instances[index].adding(_data);
                }).call(function():void
                {
                    _data.readProgress = 1;
                    refuseFileIf(_data.vertices.length == 0, _data.name, "no vertices: expected a scene or a library with a geometry in it");
                });
        }
    }
}
