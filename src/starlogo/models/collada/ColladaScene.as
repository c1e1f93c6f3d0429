package starlogo.models.collada
{
    import starlogo.models.AffineTransform;
    import starlogo.models.ModelBudget;
    import starlogo.models.TextTokens;
    import starlogo.models.refuseIf;
    import starlogo.steps.StepSequence;

    /** Visits the nodes of a COLLADA scene and finds their geometries. If there is no scene, it takes all geometries of the library. */
    internal final class ColladaScene extends StepSequence
    {
        private static const PARTS_PER_STEP:int = 100;
        private static const MAX_DEPTH:int = 256;
        private static const MAX_CONTROLLERS:int = 16;

        // a placed element takes more memory than an element
        private static const THINGS_PER_PART:int = 2;

        /** The geometries in the document's order, when no step is left. */
        public var instances:Vector.<ColladaInstance> = new Vector.<ColladaInstance>();

        private var _document:ColladaDocument;
        private var _pending:Vector.<ColladaNode> = new Vector.<ColladaNode>();

        // the node that is visited, the next element in it, and the nodes found in it so far
        private var _node:ColladaNode = null;
        private var _child:int = 0;
        private var _nodes:Vector.<ColladaNode> = new Vector.<ColladaNode>();

        /**
         * @param document the document
         * @param up turns the scene to z up
         */
        public function ColladaScene(document:ColladaDocument, up:AffineTransform)
        {
            _document = document;
            var scene:ColladaElement = document.root.child("scene");
            var instance:ColladaElement = scene == null ? null : scene.child("instance_visual_scene");
            if (instance != null)
            {
                _pending.push(new ColladaNode(document.target(instance, "url", ["visual_scene"]), null, up));
                repeat(walk);
            }
            else
            {
                addLibrary(up);
            }
        }

        private function walk():Boolean
        {
            for (var i:int = 0; i < PARTS_PER_STEP && (_node != null || _pending.length > 0); i++)
            {
                if (_node == null)
                {
                    enter(_pending.pop());
                }
                else if (_child < _node.element.children.length)
                {
                    visit(_node.element.children[_child++]);
                }
                else
                {
                    leave();
                }
            }
            return _node != null || _pending.length > 0;
        }

        private function addLibrary(up:AffineTransform):void
        {
            for each (var library:ColladaElement in _document.root.childrenNamed("library_geometries"))
            {
                for each (var geometry:ColladaElement in library.childrenNamed("geometry"))
                {
                    instances.push(new ColladaInstance(geometry, geometry, up));
                }
            }
        }

        private function enter(node:ColladaNode):void
        {
            refuseIf(node.depth > MAX_DEPTH, _document.budget.name, "its nodes are nested more than " + MAX_DEPTH + " deep", node.element);
            _document.budget.take(ModelBudget.THINGS, THINGS_PER_PART * (1 + node.element.children.length), node.element);
            _node = node;
            _child = 0;
        }

        private function visit(element:ColladaElement):void
        {
            switch (element.name)
            {
                case "instance_geometry":
                    instances.push(new ColladaInstance(element, _document.target(element, "url", ["geometry"]), _node.transform));
                    break;
                case "instance_controller":
                    addController(element, _node.transform);
                    break;
                case "instance_node":
                    _nodes.push(new ColladaNode(instanced(element, _node), _node, _node.transform));
                    break;
                case "node":
                    _nodes.push(new ColladaNode(element, _node, _node.transform));
                    break;
                default:
                    var local:AffineTransform = element.transform ||= ColladaTransform.of(_document, element);
                    _node.transform = local == null ? _node.transform : _node.transform.after(local);
                    break;
            }
        }

        private function leave():void
        {
            while (_nodes.length > 0)
            {
                _pending.push(_nodes.pop());
            }
            _node = null;
        }

        private function instanced(element:ColladaElement, node:ColladaNode):ColladaElement
        {
            var target:ColladaElement = _document.target(element, "url", ["node"]);
            refuseIf(node.isWithin(target), _document.budget.name, "recursive instance_node: it places the node \"" +
                    TextTokens.shorten(target.id) + "\" within itself", element);
            return target;
        }

        /** Follows controllers down to the geometry. A skin stays where its bind shape matrix puts it. A morph is its base shape. */
        private function addController(element:ColladaElement, transform:AffineTransform):void
        {
            var target:ColladaElement = _document.target(element, "url", ["controller"]);
            for (var i:int = 0; target.name == "controller"; i++)
            {
                _document.budget.take(ModelBudget.THINGS, THINGS_PER_PART, element);
                var skin:ColladaElement = target.child("skin");
                var deformer:ColladaElement = skin || _document.requiredChild(target, "morph");
                var shape:ColladaElement = skin == null ? null : skin.child("bind_shape_matrix");
                transform = shape == null ? transform : transform.after(shape.transform ||= ColladaTransform.matrix(_document, shape));
                target = _document.target(deformer, "source", ["geometry", "controller"]);
                refuseIf(i > MAX_CONTROLLERS, _document.budget.name, "more than " + MAX_CONTROLLERS +
                        " controllers follow one another, or they refer to each other in a circle", element);
            }
            instances.push(new ColladaInstance(element, target, transform));
        }
    }
}
