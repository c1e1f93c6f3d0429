package support
{
    import starlogo.libraries.HierarchiesLibrary;

    /**
     * Fails unless a hierarchy is what its library promises: levels and leaves within the settings, every vertex or triangle
     * under just one leaf, counts that add up, and structures around all that is under a node, boxes tightly and inside of
     * their parents'.
     *
     * @param library has the hierarchy and the settings that it was built with
     * @param name the shape
     * @param vertices what it was built from
     * @param triangles what it was built from
     */
    public function assertWellFormed(library:HierarchiesLibrary, name:String, vertices:Vector.<Number>, triangles:Vector.<uint> = null):void
    {
        new WellFormedCheck(library, name, vertices, triangles).run();
    }
}

import flash.geom.Vector3D;
import org.flexunit.asserts.assertEquals;
import org.flexunit.asserts.assertNull;
import org.flexunit.asserts.assertTrue;
import org.flexunit.asserts.fail;
import starlogo.bounding.BoundingStructure;
import starlogo.bounding.Box;
import starlogo.hierarchy.HierarchyNode;
import starlogo.libraries.HierarchiesLibrary;

class WellFormedCheck
{
    private var _library:HierarchiesLibrary;
    private var _name:String;
    private var _vertices:Vector.<Number>;
    private var _triangles:Vector.<uint>;
    private var _timesSeen:Vector.<int>;
    private var _point:Vector3D = new Vector3D();
    private var _largest:Number = 0;
    private var _slack:Number;

    public function WellFormedCheck(library:HierarchiesLibrary, name:String, vertices:Vector.<Number>, triangles:Vector.<uint>)
    {
        _library = library;
        _name = name;
        _vertices = vertices;
        _triangles = triangles != null && triangles.length > 0 ? triangles : null;
        _timesSeen = new Vector.<int>(_triangles == null ? vertices.length / 3 : _triangles.length / 3);
        for (var i:int = 0; i < vertices.length; i++)
        {
            _largest = Math.max(_largest, Math.abs(vertices[i]));
        }
        _slack = 3e-13 * _largest;
    }

    public function run():void
    {
        var root:HierarchyNode = _library.root(_name);
        check(root, 1, null);
        for (var i:int = 0; i < _timesSeen.length; i++)
        {
            if (_timesSeen[i] != 1)
            {
                fail(_name + ": item " + i + " is under " + _timesSeen[i] + " leaves");
            }
        }
    }

    private function check(node:HierarchyNode, level:int, parent:HierarchyNode):void
    {
        var items:Vector.<int> = _triangles == null ? node.vertexIndices() : node.triangleIndices();
        assertTrue("a node has something", items.length > 0);
        assertEquals(_triangles == null ? 0 : items.length, node.triangleCount);
        assertEquals(distinct(verticesOf(items)), node.vertexCount);
        assertTrue("level", level <= _library.maxDepth);
        if (node.bounds.kind == BoundingStructure.BOX)
        {
            checkBox(node, level, items, parent);
        }
        checkContains(node, items);
        if (node.isLeaf)
        {
            assertNull(node.left);
            assertNull(node.right);
            for each (var item:int in items)
            {
                _timesSeen[item]++;
            }
            if (node.vertexCount > _library.minVerticesToSplit && level < _library.maxDepth)
            {
                checkIndivisible(items);
            }
            return;
        }
        checkCounts(node, items.length);
        check(node.left, level + 1, node);
        check(node.right, level + 1, node);
    }

    private function checkCounts(node:HierarchyNode, count:int):void
    {
        var together:int = node.left.vertexCount + node.right.vertexCount;
        if (_triangles == null)
        {
            assertTrue("was to be split", count > _library.minVerticesToSplit);
            assertEquals("counts add up", node.vertexCount, together);
            return;
        }
        // with triangles that are alike, there may be more of them than their vertices allow
        var few:int = _library.minVerticesToSplit;
        assertTrue("was to be split", node.vertexCount > few || count > few * (few - 1) * (few - 2) / 6);
        assertEquals("counts add up", count, node.left.triangleCount + node.right.triangleCount);
        assertTrue("shared vertices count on either side", node.vertexCount <= together);
    }

    // Extents, and the parent's.
    private function checkBox(node:HierarchyNode, level:int, items:Vector.<int>, parent:HierarchyNode):void
    {
        var box:Box = Box(node.bounds);
        var low:Array = [Infinity, Infinity, Infinity];
        var high:Array = [-Infinity, -Infinity, -Infinity];
        for each (var vertex:int in verticesOf(items))
        {
            for (var axis:int = 0; axis < 3; axis++)
            {
                low[axis] = Math.min(low[axis], _vertices[3 * vertex + axis]);
                high[axis] = Math.max(high[axis], _vertices[3 * vertex + axis]);
            }
        }
        var halves:Array = [box.halfX, box.halfY, box.halfZ];
        var middle:Array = [box.center.x, box.center.y, box.center.z];
        for (axis = 0; axis < 3; axis++)
        {
            assertTrue("no more than around its part", Math.abs(low[axis] - middle[axis] + halves[axis]) <= _slack);
            assertTrue("no more than around its part", Math.abs(high[axis] - middle[axis] - halves[axis]) <= _slack);
        }
        if (parent == null)
        {
            return;
        }
        var outer:Box = Box(parent.bounds);
        // by more than rounding, but for hundreds of levels
        var slack:Number = level < 64 ? -2e-15 * _largest : _slack;
        assertTrue("inside of its parent", Math.abs(box.center.x - outer.center.x) + box.halfX <= outer.halfX + slack
                && Math.abs(box.center.y - outer.center.y) + box.halfY <= outer.halfY + slack
                && Math.abs(box.center.z - outer.center.z) + box.halfZ <= outer.halfZ + slack);
    }

    private function checkContains(node:HierarchyNode, items:Vector.<int>):void
    {
        for each (var vertex:int in verticesOf(items))
        {
            _point.x = _vertices[3 * vertex];
            _point.y = _vertices[3 * vertex + 1];
            _point.z = _vertices[3 * vertex + 2];
            if (!node.bounds.contains(_point))
            {
                fail(_name + ": vertex " + vertex + " is outside of its node");
            }
        }
    }

    // Many items, and not at the depth limit: only where all have the same middle.
    private function checkIndivisible(items:Vector.<int>):void
    {
        var first:String = middleOf(items[0]);
        for each (var item:int in items)
        {
            assertEquals("could be split", first, middleOf(item));
        }
    }

    private function middleOf(item:int):String
    {
        var middle:Array = [];
        for (var axis:int = 0; axis < 3; axis++)
        {
            var a:Number = _vertices[3 * (_triangles == null ? item : _triangles[3 * item]) + axis];
            var b:Number = _triangles == null ? a : _vertices[3 * _triangles[3 * item + 1] + axis];
            var c:Number = _triangles == null ? a : _vertices[3 * _triangles[3 * item + 2] + axis];
            middle.push(Math.min(a, b, c) + Math.max(a, b, c));
        }
        return middle.join(" ");
    }

    private function verticesOf(items:Vector.<int>):Vector.<int>
    {
        if (_triangles == null)
        {
            return items;
        }
        var vertices:Vector.<int> = new Vector.<int>();
        for each (var item:int in items)
        {
            vertices.push(_triangles[3 * item], _triangles[3 * item + 1], _triangles[3 * item + 2]);
        }
        return vertices;
    }

    private function distinct(vertices:Vector.<int>):int
    {
        var isCounted:Object = {};
        var count:int = 0;
        for each (var vertex:int in vertices)
        {
            count += isCounted[vertex] ? 0 : 1;
            isCounted[vertex] = true;
        }
        return count;
    }
}
