package starlogo.models.collada
{
    import flash.geom.Vector3D;
    import starlogo.geometry.AffineTransform;
    import starlogo.models.Model;
    import starlogo.models.ModelTransform;
    import starlogo.models.animation.Pose;
    import starlogo.models.building.FormatReader;
    import starlogo.models.building.ModelData;
    import starlogo.models.building.removingUnusedVertices;
    import starlogo.models.files.refuseModelIf;
    import starlogo.models.files.shortened;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Reads a COLLADA document, at rest or in a pose. ColladaModel says which parts. Its steps visit the nodes of the scene, and find where these are,
     * and their geometries. If there is no scene, it takes all geometries of the library.
     *
     * <p>A ColladaDocument has an XmlReader, which makes ColladaElements of the text, and keeps what several poses share. The transforms of
     * ColladaNodes come from ColladaTransforms. Each geometry is a ColladaMesh. It has the points of ColladaAccessors, and
     * the triangles of ColladaPrimitives. Each instance of a geometry is a ColladaInstance, which adds the mesh to the model.</p>
     *
     * <p>Before that, it moves the points of a geometry that a controller places. It does so by morphs and by ColladaSkins. A ColladaSkin has the
     * JointInfluences of its points, and finds its joints among the nodes.</p>
     *
     * @private
     */
    public final class ColladaReader extends StepSequence implements FormatReader
    {
        private static const ELEMENTS_PER_STEP:int = 100;
        private static const MAX_DEPTH:int = 256;
        private static const MAX_CONTROLLERS:int = 16;
        private static const NO_DEFORMERS:Vector.<ColladaElement> = new Vector.<ColladaElement>();

        // a node takes more memory than an element
        private static const ELEMENTS_PER_NODE:int = 2;

        /** The document. Its readers share its geometries and skins. Read only. */
        internal var document:ColladaDocument;

        private var _data:ModelData;
        private var _pose:Pose;
        private var _instances:Vector.<ColladaInstance> = new Vector.<ColladaInstance>(); // in the document's order

        // The nodes so far, and lists of the indices of an element's nodes, by the element's index. Then the node around the next element; null at the
        // end.
        private var _nodes:Vector.<ColladaNode> = new Vector.<ColladaNode>();
        private var _nodeIndices:Object = {};
        private var _node:ColladaNode = null;

        /**
         * @param document the document; its steps may be done
         * @param upAxis "x", "y" or "z"; a ModelTransform leaves the document as it is; null for the axis that the document names
         * @param scaling as for Model's constructor; null if the vertices are not normalised
         * @param pose the pose, whose targets are the elements' indices; null at rest
         */
        public function ColladaReader(document:ColladaDocument, upAxis:Object, scaling:String, pose:Pose = null)
        {
            this.document = document;
            _pose = pose;
            _data = ModelData.forFile(document.budget.modelName, upAxis, scaling, "y");
            add(document).call(function():void
                {
                    _data.upAxis = upAxis == null ? document.upAxis : _data.upAxis;
                    if (scaling == Model.AS_GIVEN && _data.transform == null && document.metresPerUnit != 1)
                    {
                        _data.transform = new ModelTransform(null, new Vector3D(document.metresPerUnit, document.metresPerUnit, document.metresPerUnit));
                    }
                    enterScene();
                }).repeat(visitSome).begin(addingInstances).add(removingUnusedVertices(_data.vertices, _data.triangles));
        }

        /** @inheritDoc */
        public function get data():ModelData
        {
            return _data;
        }

        /** Whether there is no pose. */
        public function get isAtRest():Boolean
        {
            return _pose == null;
        }

        /** The numbers of an element in the pose; null if they are its own. */
        public function posedNumbersOf(element:ColladaElement):Vector.<Number>
        {
            return isAtRest ? null : _pose.numbersOf(String(element.index));
        }

        /**
         * The transform from a joint to the scene, when no step is left.
         *
         * @param joint the joint's element
         * @param skinNode the node with the skin. Of several nodes of the joint, the nearest one counts
         * @param skin the skin's element, for the error
         * @throws ModelError if the joint is not in the scene
         */
        public function jointTransform(joint:ColladaElement, skinNode:ColladaNode, skin:ColladaElement):AffineTransform
        {
            var indices:Vector.<Number> = _nodeIndices[joint.index];
            skin.refuseIf(indices == null, "its joint \"" + shortened(joint.attribute("sid") || joint.id) + "\" is not in the scene");
            return _nodes[skinNode.withLowestCommonAncestor(indices)].transform;
        }

        private function enterScene():void
        {
            var scene:ColladaElement = document.root.child("scene");
            var instance:ColladaElement = scene == null ? null : scene.child("instance_visual_scene");
            if (instance != null)
            {
                enter(instance.target("url", ["visual_scene"]));
                return;
            }
            for each (var geometry:ColladaElement in document.entriesOf("library_geometries", "geometry"))
            {
                addInstance(geometry, geometry, NO_DEFORMERS);
            }
        }

        private function visitSome():Boolean
        {
            for (var i:int = 0; i < ELEMENTS_PER_STEP && _node != null; i++)
            {
                var element:ColladaElement = _node.nextElement();
                if (element == null)
                {
                    _node.exit(_nodes.length);
                    _node = _node.parent;
                }
                else
                {
                    visit(element);
                }
            }
            return _node != null;
        }

        // The children of an element are visited next.
        private function enter(element:ColladaElement):void
        {
            (_nodeIndices[element.index] ||= new Vector.<Number>()).push(_nodes.length);
            _node = new ColladaNode(element, _node, _nodes.length);
            _nodes.push(_node);
            element.refuseIf(_node.depth > MAX_DEPTH, "its nodes are nested more than " + MAX_DEPTH + " deep");
            element.budget.spendElements(ELEMENTS_PER_NODE * (1 + element.children.length), element);
        }

        // Visits a child of the present node's element.
        private function visit(element:ColladaElement):void
        {
            switch (element.name)
            {
                case "instance_geometry":
                    addInstance(element, element.target("url", ["geometry"]), NO_DEFORMERS);
                    break;
                case "instance_controller":
                    addController(element);
                    break;
                case "instance_node":
                    var inner:ColladaElement = element.target("url", ["node"]);
                    element.refuseIf(_node.isWithin(inner), "recursive instance_node: it places the node \"" + shortened(inner.id) + "\" within itself");
                    enter(inner);
                    break;
                case "node":
                    enter(element);
                    break;
                default:
                    var numbers:Vector.<Number> = posedNumbersOf(element);
                    var local:AffineTransform = numbers == null ? element.toTransform() : ColladaTransform.of(element, numbers);
                    if (local != null)
                    {
                        _node.addTransform(local);
                    }
            }
        }

        // Follows controllers down to the geometry, and finds their skins and morphs.
        private function addController(element:ColladaElement):void
        {
            var deformers:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            var target:ColladaElement = element.target("url", ["controller"]);
            while (target.name == "controller")
            {
                element.budget.spendElements(ELEMENTS_PER_NODE, element);
                var deformer:ColladaElement = target.child("skin") || target.requiredChild("morph");
                target = deformer.target("source", ["geometry", "controller"]);
                element.refuseIf(deformers.length == MAX_CONTROLLERS, "more than " + MAX_CONTROLLERS +
                        " controllers follow one another, or they refer to each other in a circle");
                deformers.push(deformer);
            }
            addInstance(element, target, deformers);
        }

        private function addInstance(element:ColladaElement, geometry:ColladaElement, deformers:Vector.<ColladaElement>):void
        {
            _instances.push(new ColladaInstance(this, element, _node, document.meshOf(geometry), deformers));
        }

        private function addingInstances():Steps
        {
            var count:int = _instances.length;
            // all geometries come first, so skins only have what these leave of the limits
            return new StepSequence().beginEach(count, function(index:int):Steps
                {
                    _data.readProgress = index / count / 2;
                    return _instances[index].mesh;
                }).beginEach(count, function(index:int):Steps
                {
                    _data.readProgress = (1 + index / count) / 2;
                    return _instances[index].adding(_data);
                }).call(function():void
                {
                    _data.readProgress = 1;
                    refuseModelIf(_data.vertices.length == 0, _data.name, "no vertices: expected a scene or a library with a geometry in it");
                });
        }
    }
}
