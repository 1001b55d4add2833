# bash completion of angiopose
_angiopose()
{
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}
    if [[ $current == = ]]; then
        current=
    elif [[ $previous == = && $COMP_CWORD -gt 1 ]]; then
        previous=${COMP_WORDS[COMP_CWORD-2]}
    fi
    if [[ $previous == --renderer ]]; then
        mapfile -t COMPREPLY < <(compgen -W 'auto vtk painter' -- "$current")
    elif [[ $previous == --language ]]; then
        mapfile -t COMPREPLY < <(compgen -W 'en de zh_CN' -- "$current")
    elif [[ $current == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W '-h --help --help-all -v --version --renderer --report --register --template --author
            --identity --language' -- "$current")
    else
        compopt -o filenames 2>/dev/null
        mapfile -t COMPREPLY < <(compgen -f -- "$current")
    fi
    return 0
}
complete -F _angiopose angiopose
