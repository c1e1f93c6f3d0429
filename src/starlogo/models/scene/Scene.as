package starlogo.models.scene
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.animation.Pose;
    import starlogo.models.building.ModelData;
    import starlogo.models.building.removingUnusedVertices;
    import starlogo.models.files.FileBudget;
    import starlogo.models.files.refuseModelIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * The scene of a COLLADA document or a glTF file: nodes, and instances of meshes at nodes. The reader of the format adds the steps that fill it.
     * Then its meshes are added to a model, at rest, or again and again in the poses of an animation.
     *
     * @private
     */
    public final class Scene extends StepSequence
    {
        /** The model at rest. It has the name, and the up axis when the scene is read. Read only. */
        public var data:ModelData;

        /** What the file may have and cost. Read only. */
        public var budget:FileBudget;

        /** The instances of meshes, in the order of the scene. The reader adds them. */
        public var instances:Vector.<MeshInstance> = new Vector.<MeshInstance>();

        /** The present pose; null at rest. Read only. */
        public var pose:Pose = null;

        /** The node around each node; -1 for none. The reader sets it. */
        public var parents:Vector.<int> = new Vector.<int>();

        private var _placing:Function;

        // the transform of each node in the present pose; null before it is first needed
        private var _transforms:Vector.<AffineTransform> = new Vector.<AffineTransform>();

        /**
         * @param data the model at rest
         * @param budget what the file may have and cost
         * @param placing <code>function(node:int, around:AffineTransform):AffineTransform</code>; returns the transform from a node to the scene, in the
         * present pose. Takes that of the node around it
         */
        public function Scene(data:ModelData, budget:FileBudget, placing:Function)
        {
            this.data = data;
            this.budget = budget;
            _placing = placing;
        }

        /** Adds a node. Nodes have indices in this order. @param parent the node around it; -1 for none, or if that is set later */
        public function addNode(parent:int):void
        {
            parents.push(parent);
            _transforms.push(null);
        }

        /**
         * The transform from a node to the scene, in the present pose. @param node its index; -1 for the scene itself
         *
         * @throws ModelError if a transform is wrong, or the node contains itself
         */
        public function transformOf(node:int):AffineTransform
        {
            var chain:Vector.<int> = new Vector.<int>();
            for (var i:int = node; i >= 0 && _transforms[i] == null; i = parents[i])
            {
                refuseModelIf(chain.length > parents.length, data.name, "it contains itself", "nodes[" + node + "]");
                chain.push(i);
            }
            var transform:AffineTransform = i < 0 ? new AffineTransform() : _transforms[i];
            while (chain.length > 0)
            {
                i = chain.pop();
                transform = _placing(i, transform);
                _transforms[i] = transform;
            }
            return transform;
        }

        /** The steps that add all instances to a model, in the present pose. */
        public function adding(model:ModelData):Steps
        {
            var count:int = instances.length;
            return new StepSequence().beginEach(count, function(index:int):Steps
                {
                    model.readProgress = Math.max(model.readProgress, index / count);
                    return instances[index].adding(model);
                }).call(function():void
                {
                    model.readProgress = 1;
                    refuseModelIf(model.vertices.length == 0, model.name, "no vertices: expected a mesh in the scene");
                }).add(removingUnusedVertices(model.vertices, model.triangles));
        }

        /** Brings the nodes into a pose. What the file may cost counts anew, because its meshes are placed once more. */
        public function enter(newPose:Pose):void
        {
            pose = newPose;
            for (var i:int = 0; i < _transforms.length; i++)
            {
                _transforms[i] = null;
            }
            budget.reset();
        }
    }
}
