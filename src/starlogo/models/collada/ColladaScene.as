package starlogo.models.collada
{
    import flash.geom.Vector3D;
    import starlogo.data.lastAtMost;
    import starlogo.geometry.AffineTransform;
    import starlogo.models.Model;
    import starlogo.models.ModelTransform;
    import starlogo.models.files.FileBudget;
    import starlogo.models.files.ModelFile;
    import starlogo.models.files.refuseModelIf;
    import starlogo.models.files.shortened;
    import starlogo.models.scene.MeshInstance;
    import starlogo.models.scene.Scene;
    import starlogo.models.text.Decimal;
    import starlogo.models.text.TextWords;

    /**
     * The scene of a COLLADA document. ColladaModel says which parts are read. The steps visit the nodes, and find the instances of geometries. If the
     * document has no scene, they take all geometries of the library.
     *
     * <p>An XmlReader makes ColladaElements of the text. The transforms of nodes come from ColladaTransforms. An element that other nodes instantiate is
     * several nodes of the Scene. Each geometry becomes a ColladaMesh, with the points of ColladaAccessors and the triangles of ColladaPrimitives.
     * A ColladaController moves its points by skins and morphs.</p>
     *
     * @private
     */
    public final class ColladaScene extends Scene
    {
        private static const ELEMENTS_PER_STEP:int = 100;
        private static const MAX_DEPTH:int = 256;

        /** How many elements a node counts as, because it takes more memory. */
        internal static const ELEMENTS_PER_NODE:int = 2;

        /** The steps that read the document's elements. Read only. */
        internal var xml:XmlReader;

        private var _meshes:Object = {}; // by the index of the geometry's element
        private var _skins:Object = {}; // by the index of the skin's element

        // the element of each node, and lists of an element's nodes, by the element's index
        private var _elements:Vector.<ColladaElement> = new Vector.<ColladaElement>();
        private var _nodes:Object = {};

        // the elements that are visited next, the last one first, and the node that each is in
        private var _pending:Vector.<ColladaElement> = new Vector.<ColladaElement>();
        private var _pendingNodes:Vector.<int> = new Vector.<int>();

        /**
         * @param file the document
         * @param upAxis "x", "y" or "z"; a ModelTransform leaves the document as it is; null for the axis that the document names
         * @param scaling as for Model's constructor; null if the vertices are not normalised
         */
        public function ColladaScene(file:ModelFile, upAxis:Object, scaling:String)
        {
            super(new FileBudget(file.name, file.requireText().length), upAxis, scaling);
            xml = new XmlReader(file.requireText(), budget);
            add(xml).call(function():void
                {
                    readAsset(upAxis == null, scaling);
                    addScene();
                }).repeat(visitSome);
        }

        /** The root, when the elements are read. @throws ModelError if it is not COLLADA */
        internal function get root():ColladaElement
        {
            refuseModelIf(xml.root == null, data.name, "this is not XML: expected a COLLADA document");
            xml.root.refuseIf(xml.root.name != "COLLADA", "expected a COLLADA document, but its root element is <" + xml.root.name + ">");
            return xml.root;
        }

        /** The children with a name of all libraries with a name. */
        internal function entriesOf(libraryName:String, name:String):Vector.<ColladaElement>
        {
            var entries:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            for each (var library:ColladaElement in root.childrenNamed(libraryName))
            {
                for each (var entry:ColladaElement in library.childrenNamed(name))
                {
                    entries.push(entry);
                }
            }
            return entries;
        }

        /**
         * The transform from a joint's node to the scene. A joint may have several nodes. The one with the lowest ancestor in common with the skin's node
         * counts, the first of several. So each of several figures has joints of its own.
         */
        internal function jointTransform(joint:ColladaElement, skinNode:int, skin:ColladaElement):AffineTransform
        {
            var nodes:Vector.<Number> = _nodes[joint.index];
            skin.refuseIf(nodes == null, "its joint \"" + shortened(joint.attribute("sid") || joint.id) + "\" is not in the scene");
            if (nodes.length == 1)
            {
                return transformOf(nodes[0]); // looks for no ancestors, which may be many
            }
            // nodes have the order of the visit, so the lowest ancestor is that of the joint's last node before the skin's, or of the next one
            var before:int = lastAtMost(nodes, skinNode);
            var next:int = Math.min(before + 1, nodes.length - 1);
            var ancestor:int = Math.max(commonAncestor(nodes[before], skinNode), commonAncestor(nodes[next], skinNode));
            var first:int = lastAtMost(nodes, ancestor - 1);
            return transformOf(nodes[first] < ancestor ? nodes[first + 1] : nodes[first]);
        }

        // The lowest node around two nodes, which may be one of these. Nodes come after those around them.
        private function commonAncestor(node:int, other:int):int
        {
            while (node != other)
            {
                if (node > other)
                {
                    node = parents[node];
                }
                else
                {
                    other = parents[other];
                }
            }
            return node;
        }

        // The up axis is y if none is named. A unit that is no length counts as a metre.
        private function readAsset(usesAxis:Boolean, scaling:String):void
        {
            var asset:ColladaElement = root.child("asset");
            var axis:ColladaElement = asset == null || !usesAxis ? null : asset.child("up_axis");
            var unit:ColladaElement = asset == null ? null : asset.child("unit");
            if (axis != null)
            {
                var named:String = TextWords.trimmed(axis.text);
                axis.refuseIf(!/^[XYZ]_UP$/.test(named), "expected X_UP, Y_UP or Z_UP, but found \"" + shortened(named) + "\"");
                data.upAxis = named.charAt(0).toLowerCase();
            }
            var metres:Number = unit == null ? 1 : Decimal.of(unit.attribute("meter"));
            if (scaling == Model.AS_GIVEN && data.transform == null && metres > 0 && metres < Infinity && metres != 1)
            {
                data.transform = new ModelTransform(null, new Vector3D(metres, metres, metres));
            }
        }

        private function addScene():void
        {
            var shown:ColladaElement = root.child("scene");
            var instance:ColladaElement = shown == null ? null : shown.child("instance_visual_scene");
            if (instance != null)
            {
                placeNode(instance.target("url", ["visual_scene"]), -1, instance);
                return;
            }
            for each (var geometry:ColladaElement in entriesOf("library_geometries", "geometry"))
            {
                addInstance(geometry, geometry, -1);
            }
        }

        private function visitSome():Boolean
        {
            for (var i:int = 0; i < ELEMENTS_PER_STEP && _pending.length > 0; i++)
            {
                visit(_pending.pop(), _pendingNodes.pop());
            }
            return _pending.length > 0;
        }

        // Adds a node for an element. The element's children are visited next.
        // @param around the node around it; -1 for none
        // @param placer the element that places it there, for errors
        private function placeNode(element:ColladaElement, around:int, placer:ColladaElement):void
        {
            var depth:int = 0;
            for (var outer:int = around; outer >= 0; outer = parents[outer])
            {
                if (_elements[outer] == element)
                {
                    throw placer.error("recursive instance_node: it places the node \"" + shortened(element.id) + "\" within itself");
                }
                depth++;
            }
            placer.refuseIf(depth > MAX_DEPTH, "nodes are nested more than " + MAX_DEPTH + " deep");
            element.budget.spendElements(ELEMENTS_PER_NODE * (1 + element.children.length), element);
            var node:int = addNode(around);
            _elements.push(element);
            (_nodes[element.index] ||= new Vector.<Number>()).push(node);
            for (var i:int = element.children.length - 1; i >= 0; i--)
            {
                _pending.push(element.children[i]);
                _pendingNodes.push(node);
            }
        }

        /** @inheritDoc By the transforms in its element. */
        override protected function transformIn(node:int, around:AffineTransform):AffineTransform
        {
            for each (var child:ColladaElement in _elements[node].children)
            {
                var numbers:Vector.<Number> = posed(String(child.index));
                var local:AffineTransform = numbers == null ? child.toTransform() : ColladaTransform.of(child, numbers);
                around = local == null ? around : around.after(local);
            }
            return around;
        }

        // Visits a child of a node's element.
        private function visit(element:ColladaElement, node:int):void
        {
            switch (element.name)
            {
                case "instance_geometry":
                    addInstance(element, element.target("url", ["geometry"]), node);
                    break;
                case "instance_controller":
                    var controller:ColladaController = new ColladaController(this, element, node);
                    addInstance(element, controller.geometry, node).deforming = controller.deforming;
                    break;
                case "instance_node":
                    placeNode(element.target("url", ["node"]), node, element);
                    break;
                case "node":
                    placeNode(element, node, element);
                    break;
                default:
                    // a transform that is wrong is refused, even if nothing is at its node
                    element.toTransform();
            }
        }

        /** The skin of an element; all controllers with it share it. */
        internal function skinOf(element:ColladaElement):ColladaSkin
        {
            return _skins[element.index] ||= new ColladaSkin(element);
        }

        /** The mesh of a geometry; all its instances share it. */
        internal function meshOf(geometry:ColladaElement):ColladaMesh
        {
            return _meshes[geometry.index] ||= new ColladaMesh(geometry);
        }

        // Adds an instance of a geometry, as a mesh with the name of its node. @param element places it; the geometry itself without a scene
        private function addInstance(element:ColladaElement, geometry:ColladaElement, node:int):MeshInstance
        {
            var name:String = (element == geometry ? geometry : element.parent).nameOrId || geometry.nameOrId;
            var instance:MeshInstance = new MeshInstance(node, meshOf(geometry), element, name);
            instances.push(instance);
            return instance;
        }
    }
}
