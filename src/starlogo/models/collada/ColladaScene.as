package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.animation.Pose;
    import starlogo.models.files.shortened;
    import starlogo.steps.StepSequence;

    /**
     * The scene of a COLLADA document, at rest or in a pose. Its steps visit the nodes and find where they are, and their
     * geometries. If there is no scene, it takes all geometries of the library.
     */
    internal final class ColladaScene extends StepSequence
    {
        private static const ELEMENTS_PER_STEP:int = 100;
        private static const MAX_DEPTH:int = 256;
        private static const MAX_CONTROLLERS:int = 16;
        private static const NO_DEFORMERS:Vector.<ColladaElement> = new Vector.<ColladaElement>();

        // a node takes more memory than an element
        private static const ELEMENTS_PER_NODE:int = 2;

        /** The geometries in the document's order, when no step is left. */
        public var instances:Vector.<ColladaInstance> = new Vector.<ColladaInstance>();

        /** The document. Its scenes share its geometries and skins. Read only. */
        public var document:ColladaDocument;

        private var _nodes:Object = {}; // lists of the nodes of an element, in the order of the visit, by the element's index

        private var _pose:Pose;

        // The node around the next element, null at the end; and how many nodes there were so far.
        private var _node:ColladaNode = null;
        private var _nodeCount:int = 0;

        /**
         * @param document the document; all its steps must be done
         * @param pose the pose, whose targets are the elements' indices; null at rest
         */
        public function ColladaScene(document:ColladaDocument, pose:Pose)
        {
            this.document = document;
            _pose = pose;
            var scene:ColladaElement = document.root.child("scene");
            var instance:ColladaElement = scene == null ? null : scene.child("instance_visual_scene");
            if (instance != null)
            {
                enter(instance.target("url", ["visual_scene"]));
                repeat(visitSome);
            }
            else
            {
                for each (var geometry:ColladaElement in document.entriesOf("library_geometries", "geometry"))
                {
                    addInstance(geometry, geometry, NO_DEFORMERS);
                }
            }
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
         * What takes points of a joint to the scene, when no step is left.
         *
         * @param joint the joint's element
         * @param skinNode the node with the skin. Of several nodes of the joint, the nearest one counts
         * @param skin the skin's element, for the error
         * @throws ModelError if the joint is not in the scene
         */
        public function jointAt(joint:ColladaElement, skinNode:ColladaNode, skin:ColladaElement):AffineTransform
        {
            var nodes:Array = _nodes[joint.index];
            skin.refuseIf(nodes == null, "its joint \"" + shortened(joint.attribute("sid") || joint.id) + "\" is not in the scene");
            return skinNode.nearestOf(nodes).transform;
        }

        private function visitSome():Boolean
        {
            for (var i:int = 0; i < ELEMENTS_PER_STEP && _node != null; i++)
            {
                var element:ColladaElement = _node.nextElement();
                if (element == null)
                {
                    _node.exit(_nodeCount);
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
            _node = new ColladaNode(element, _node, _nodeCount++);
            element.refuseIf(_node.depth > MAX_DEPTH, "its nodes are nested more than " + MAX_DEPTH + " deep");
            element.budget.spendElements(ELEMENTS_PER_NODE * (1 + element.children.length), element);
            (_nodes[element.index] ||= []).push(_node);
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
                    var local:AffineTransform = transformOf(element);
                    if (local != null)
                    {
                        _node.addTransform(local);
                    }
            }
        }

        // The transform that an element is; null if it is none.
        private function transformOf(element:ColladaElement):AffineTransform
        {
            var numbers:Vector.<Number> = posedNumbersOf(element);
            return numbers == null ? element.toTransform() : ColladaTransform.of(element, numbers);
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
            instances.push(new ColladaInstance(this, element, _node, document.meshOf(geometry), deformers));
        }
    }
}
